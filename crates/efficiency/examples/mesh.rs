//! Sliding and rolling losses of a mesh cycle of two places, and the efficiency.
//!
//! ```text
//! cargo run -p asperity-efficiency --example mesh
//! ```

use asperity_efficiency::{
    LossKind, MeshOperation, PositionLoss, RollingSurfaces, mesh_efficiency, mesh_loss,
};

/// Prints the losses of a mesh.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    let place = |speed: &str| -> Result<PositionLoss, Box<dyn std::error::Error>> {
        Ok(PositionLoss {
            weight: "40 mm".parse()?,
            sliding_force: "5 N/mm".parse()?,
            sliding_speed: speed.parse()?,
            rolling_force: "160 N/m".parse()?,
            entrainment_speed: "4.5 m/s".parse()?,
        })
    };
    let loss = mesh_loss(
        &[place("-0.7 m/s")?, place("0.7 m/s")?],
        RollingSurfaces::Both,
    )?;
    let operation = MeshOperation {
        pinion_torque: "285 N m".parse()?,
        pinion_speed: "3000 1/min".parse()?,
        teeth: [50, 120],
    };
    let losses = [
        (LossKind::Sliding, loss.sliding),
        (LossKind::Rolling, loss.rolling),
    ];
    let mesh = mesh_efficiency(&operation, &losses)?;
    println!(
        "sliding {:.4}, rolling {:.4}: efficiency {:.4} %",
        loss.sliding,
        loss.rolling,
        100.0 * mesh.flow.efficiency
    );
    // 280 W of sliding and 115.2 W of rolling out of 89.5 kW.
    assert!((mesh.flow.efficiency - 0.995_586).abs() < 1e-6);
    Ok(())
}
