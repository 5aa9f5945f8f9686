//! The e-drive case from numbers and slices alone: no file is opened, no case text is read.
use asperity::prelude::*;

const RPM: f64 = std::f64::consts::PI / 30.0;
/// Loss of the e-drive stage with these flanks \[W\].
pub fn loss_w(pinion: &[f64], wheel: &[f64], dx: Length) -> Result<f64, asperity::Error> {
    let mut gears = GearsInput::new([23, 68], Length::from_si(1.8e-3), Length::from_si(35e-3));
    gears = gears.unrelieved();
    gears.helix = Some(Angle::from_si(23.4 * (std::f64::consts::PI / 180.0)));
    gears.face_width = OneOrTwo::Two([Length::from_si(35e-3), Length::from_si(32e-3)]);
    let oil = LubricantInput {
        viscosity: Some(ViscosityLaw::AstmD341 {
            at_40: KinematicViscosity::from_si(30.8e-6),
            at_100: KinematicViscosity::from_si(5.9e-6),
        }),
        density: Some(Density::from_si(845.0)),
        base_oil: Some(BaseOil::Pao),
        ..LubricantInput::default()
    };
    let (torque, speed) = (Torque::from_si(145.0), AngularSpeed::from_si(9000.0 * RPM));
    let operation = OperationInput::new(torque, speed, Temperature::from_si(363.15));
    let case = Case::builder(gears, operation, oil)
        .pinion(Trace::from_heights(pinion, dx)?)
        .wheel(Trace::from_heights(wheel, dx)?.mirrored())
        .change(|input| input.surface.cutoff = Some(Length::from_si(0.25e-3)))
        .change(|input| input.material.pinion.elastic_limit = Some(Pressure::from_si(1500e6)))
        .change(|input| input.material.pinion.flow_pressure = Some(Pressure::from_si(7e9)));
    let outcome = asperity::Run::new(&case.build()?).execute()?.into_only()?;
    Ok(outcome.result.summary.loss_w)
}

/// Prints the loss with two flanks made here.
pub fn main() -> Result<(), asperity::Error> {
    let metres = |line: &str| Some(line.split_once(',')?.1.parse::<f64>().ok()? / 1e6);
    let read = |csv: &str| csv.lines().filter_map(metres).collect::<Vec<_>>();
    let pinion = read(include_str!("../../../fixtures/profiles/ground_pinion.csv"));
    let wheel = read(include_str!("../../../fixtures/profiles/ground_wheel.csv"));
    println!("{} W", loss_w(&pinion, &wheel, Length::from_si(0.5e-6))?);
    Ok(())
}
