//! Tables of a rig: what is read, and what is refused with its line.

#![allow(clippy::unwrap_used, reason = "helpers of tests may panic")]

use asperity_calibration::{RigTable, Scope};
use asperity_core::Fault;

const HEAD: &str = "torque_nm,speed_rpm,temperature_c,loss_w,sigma_w,includes";

fn read(text: &str) -> Result<RigTable, Fault> {
    RigTable::read("rig.csv", text)
}

/// The message about a table of these rows under the usual header.
fn refused(rows: &str) -> String {
    let error = read(&format!("{HEAD}\n{rows}\n")).unwrap_err();
    assert_eq!(error.code(), "E134");
    error.to_string()
}

#[test]
fn a_table_is_read_without_regard_to_case_and_order_of_its_columns() {
    let text = "# SIMULATED for a test\nIncludes,LOSS_W,Sigma_W,Torque_Nm,Speed_rpm,Temperature_C,Assembly,order,note\n\
                mesh+bearings,300,9,183.4,2166,90,B,4,warm\n\nMesh,310,9,183.4,2166,90,A,5,\n";
    let table = read(text).unwrap();
    assert!(table.is_simulated);
    let warnings: Vec<String> = table.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        warnings,
        ["W454 columns of rig.csv that are not read: note"]
    );
    assert_eq!(table.assemblies(), ["B", "A"]);
    let row = &table.rows[0];
    assert_eq!(
        (row.line, row.includes, row.order),
        (3, Scope::MeshAndBearings, Some(4.0))
    );
    assert_eq!((row.torque_nm, row.loss_w), (183.4, 300.0));
    assert_eq!(
        (table.rows[1].line, table.rows[1].includes),
        (5, Scope::Mesh)
    );
}

#[test]
fn a_column_marks_simulated_losses_where_comments_are_left_out() {
    let of = |mark: &str| {
        read(&format!(
            "{HEAD},simulated\n183.4,2166,90,310,9,mesh,{mark}\n"
        ))
        .unwrap()
    };
    for (mark, is_simulated) in [
        ("true", true),
        ("True", true),
        ("false", false),
        ("", false),
    ] {
        let table = of(mark);
        assert_eq!(table.is_simulated, is_simulated, "{mark}");
        assert!(table.warnings.is_empty());
    }
}

#[test]
fn a_misspelt_column_is_named_with_the_one_that_is_missing() {
    let text = format!(
        "{}\n183.4,2166,90,310,9,mesh\n",
        HEAD.replace("includes", "inculdes")
    );
    let said = read(&text).unwrap_err().to_string();
    assert!(
        said.contains("column inculdes is not known; write includes"),
        "{said}"
    );
}

#[test]
fn a_loss_torque_is_a_power_and_semicolons_bring_decimal_commas() {
    let text = "torque_nm;speed_rpm;temperature_c;torque_loss_nm;sigma_w;includes\n183,4;3000;90;1,5;12;mesh\n";
    let row = read(text).unwrap().rows.remove(0);
    assert!((row.loss_w - 1.5 * 100.0 * std::f64::consts::PI).abs() < 1e-9);
    assert_eq!(row.torque_nm, 183.4);
    assert_eq!(row.assembly, "1");
}

#[test]
fn rows_that_repeat_an_earlier_row_are_counted() {
    let [row, same, other] = [
        "183,2166,90,300,9,mesh",
        "183.0,2166,90,300,9,mesh",
        "183,2166,90,301,9,mesh",
    ];
    let table = read(&format!("{HEAD}\n{row}\n{other}\n{same}\n{same}\n")).unwrap();
    assert_eq!(table.repeated(), 2);
    let numbered = read(&format!("{HEAD},run\n{row},1\n{same},2\n")).unwrap();
    assert_eq!(numbered.repeated(), 0);
}

#[test]
fn rows_without_sigma_or_scope_are_named_all_at_once() {
    let text = refused("183,2166,90,300,,mesh\n183,2166,90,300,9,mesh\n183,2166,90,300,9,");
    assert!(text.contains("rig.csv:2: sigma_w: is missing"), "{text}");
    assert!(text.contains("rig.csv:4: includes: is missing"), "{text}");
    assert!(!text.contains("rig.csv:3"), "{text}");
}

#[test]
fn wrong_units_are_named() {
    for (row, parts) in [
        (
            "183,2166,363,300,9,mesh",
            ["temperature_c: 363 °C", "kelvin"],
        ),
        ("183,2166,90,0.3,0.009,mesh", ["loss_w: 0.3000 W", "kW"]),
        ("183,2166,90,300,0.03,mesh", ["sigma_w: 0.03 W", "share"]),
        ("183,2166,90,300,600,mesh", ["sigma_w: 600 W", "share"]),
        ("183,-2166,90,300,9,mesh", ["speed_rpm: -2166", "positive"]),
        ("0,2166,90,300,9,mesh", ["torque_nm: 0 N m", "pinion"]),
        ("183,2166,90,x,9,mesh", ["loss_w: \"x\"", "number"]),
        ("183,2166,90,inf,9,mesh", ["loss_w: \"inf\"", "finite"]),
        (
            "183,2166,90,300,9,gearbox",
            ["includes: \"gearbox\"", "mesh+bearings"],
        ),
        (
            "183,2166,90,300,9,all",
            ["includes: all includes churning", "subtract"],
        ),
    ] {
        let text = refused(row);
        for part in parts {
            assert!(text.contains(part), "{part}: {text}");
        }
    }
}

#[test]
fn columns_that_are_missing_or_of_another_unit_are_named() {
    for (head, part) in [
        (
            "torque_nm,speed_rpm,temperature_c,loss_w,includes",
            "sigma_w is missing",
        ),
        (
            "torque_nm,speed_rpm,temperature_c,sigma_w,includes",
            "loss_w (or torque_loss_nm) is missing",
        ),
        (
            "torque_nm,speed_rpm,temperature_k,loss_w,sigma_w,includes",
            "temperature_k is not known; give temperature_c",
        ),
        (
            "torque_nm,speed_rpm,temperature_c,loss_kw,sigma_w,includes",
            "loss_kw is not known; give loss_w",
        ),
        (
            "torque_nm,speed_rpm,temperature_c,loss_w,torque_loss_nm,sigma_w,includes",
            "exclude each other",
        ),
    ] {
        let error = read(&format!("{head}\n")).unwrap_err();
        assert_eq!(error.code(), "E134");
        assert!(error.to_string().contains(part), "{part}: {error}");
    }
    assert!(read(HEAD).unwrap_err().to_string().contains("no rows"));
    assert!(read("").is_err());
}

#[test]
fn a_row_with_too_few_cells_is_no_panic() {
    let error = read(&format!("{HEAD}\n183,2166\n")).unwrap_err();
    assert_eq!(error.code(), "E134");
}

proptest::proptest! {
    #[test]
    fn no_text_panics(text in "[a-z_,;\"\n0-9.#é-]{0,200}") {
        let _ = read(&text);
        let _ = read(&format!("{HEAD}\n{text}"));
    }
}
