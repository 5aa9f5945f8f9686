//! Tables of losses of a gearbox as other programs write them.

use asperity::efficiency::loss_table::LossTable;
use asperity::loss_table::read;

#[test]
fn tables_of_other_programs_and_spreadsheets_are_one() {
    let own =
        "speed_rpm,torque_nm,loss_torque_nm\n0,-10,0.5\n0,10,0.25\n100,-10,0.75\n100,10,1.5\n";
    let (own, _) = read("own.csv", own).unwrap();
    for text in [
        "Input Speed [rpm],Input Torque [Nm],Torque Loss [Nm]\n0,-10,0.5\n0,10,0.25\n100,-10,0.75\n100,10,1.5\n",
        "Input Speed [rpm],Input Torque [Nm],Torque Loss [Nm],Eff [-]\n0,-10,0.5,0\n0,10,0.25,0\n100,-10,0.75,0\n100,10,1.5,0\n",
        "Input Speed [rpm],Input Torque [Nm],Torque Loss [Nm],Eff [-]\n0,-10,0.5\n0,10,0.25\n100,-10,0.75\n100,10,1.5\n",
        "# measured\nInput Speed [1/min];Input Torque [N m];Torque Loss [N m]\n0;-10;0,5\n0;10;0,25\n100;-10;0,75\n100;10;1,5\n",
        "torque_nm\tloss_torque_nm\tspeed_rpm\n-10\t0.5\t0\n10\t0.25\t0\n-10\t0.75\t100\n10\t1.5\t100\n",
        "torque_nm\tloss_torque_nm\tspeed_rpm\r\n-10\t0,5\t0\r\n10\t0,25\t0\r\n-10\t0,75\t100\r\n10\t1,5\t100\r\n",
        "\u{feff}Speed [rpm];Torque [Nm];Loss torque [Nm]\n100;10;1,5\n100;-10;0,75\n0;10;0,25\n0;-10;0,5\n",
        "Losses of a box\nspeed,torque,loss torque\n1/min,N m,N m\n0,-10,0.5\n0,10,0.25\n100,-10,0.75\n100,10,1.5\n",
        "speed_rpm,torque_nm,loss_torque_nm\n0,-10,5e-1\n0,10,2.5E-1\n1e2,-10,.75\n100.0,+10,1.50\n\n",
        "\"speed_rpm\",\"torque_nm\",\"loss_torque_nm\"\n\"0\",\"-10\",\"0.5\"\n\"0\",\"10\",\"0.25\"\n\"100\",\"-10\",\"0.75\"\n\"100\",\"10\",\"1.5\"\n",
        "speed_rpm torque_nm loss_torque_nm\n0 -10 0.5\n0 10 0.25\n100 -10 0.75\n100 10 1.5\n",
        "SPEED_RPM;TORQUE_NM;LOSS_TORQUE_NM;;\n0;-10;0.5;;\n0;10;0.25;;\n100;-10;0.75;;\n100;10;1.5;;\n",
    ] {
        let (found, warning) =
            read("other.csv", text).unwrap_or_else(|error| panic!("{text}: {error}"));
        let warning = warning.map(|warning| warning.to_string());
        let of_vecto = "W454 columns of other.csv that are not read: Eff [-]".to_owned();
        assert_eq!(warning, text.contains(",0.5,0\n").then_some(of_vecto));
        for (torque, speed) in [(-10.0, 0.0), (0.0, 50.0), (10.0, 100.0), (5.0, 25.0)] {
            let loss = |table: &LossTable| table.loss_torque(torque, speed, 60.0).unwrap();
            assert!((loss(&found) - loss(&own)).abs() < 1e-12, "{text}");
        }
    }
    let error = read("box.csv", "Drehzahl [1/min];Verlustmoment [Nm]\n0;1\n").unwrap_err();
    assert!(
        error.to_string().starts_with("box.csv:1: speed_rpm: is missing in the columns Drehzahl [1/min], Verlustmoment [Nm]; write"),
        "{error}"
    );
}
