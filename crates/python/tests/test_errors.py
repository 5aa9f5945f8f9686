"""Every code that Python can reach is raised with its help."""

import struct

import numpy as np
import pytest

import asperity
from asperity import AsperityError, Case, _asperity, solve_contact
from conftest import CASES, PROFILES, heights, small, trace


def rows(points, cells):
    return "".join(cells(i, z) + "\n" for i, z in enumerate(heights(points)))


def waves(points, header="x_um,z_um\n"):
    return header + rows(points, lambda i, z: f"{0.5 * i:.1f},{z:.5f}")


def with_row(number, text):
    lines = waves(1000).splitlines()
    lines[number + 1] = text
    return "\n".join(lines)


def sdf(points, profiles):
    header = {
        "ManufacID": "Asperity", "CreateDate": "200720261200", "ModDate": "200720261200", "NumPoints": points,
        "NumProfiles": profiles, "Xscale": "5e-7", "Yscale": "1e-6", "Zscale": "1e-6", "Zresolution": -1,
        "Compression": 0, "DataType": 7, "CheckType": 0,
    }
    values = "\n".join(f"{z:.4f}" for z in heights(500))
    return "aISO-1.0\n" + "".join(f"{key} = {value}\n" for key, value in header.items()) + f"*\n{values}\n*\n*\n"


def digital_surf_image():
    header = bytearray(512)
    header[:12] = b"DIGITAL SURF"
    header[18] = 12
    return bytes(header)


def matlab_arrays(*names):
    def element(kind, data):
        return struct.pack("<II", kind, len(data)) + data + bytes(-len(data) % 8)

    def array(name):
        flags, sizes, numbers = struct.pack("<II", 6, 0), struct.pack("<ii", 3, 1), struct.pack("<3d", 1, 2, 3)
        parts = [(6, flags), (5, sizes), (1, name), (9, numbers)]
        return element(14, b"".join(element(*part) for part in parts))

    return b"MATLAB 5.0 MAT-file".ljust(124, b"\0") + b"\x00\x01IM" + b"".join(map(array, names))


def read(text, name="flank.csv", **options):
    def raised(place):
        file = place / name
        file.write_bytes(text if isinstance(text, bytes) else text.encode())
        asperity.read_profile(file, **options).parameters()

    return raised


def huge(place):
    with open(place / "huge.csv", "w") as file:
        file.write("x_um,z_um\n")
        # A file with a hole in it takes no room on the disk.
        file.truncate(5 << 30)
    asperity.read_profile(place / "huge.csv")


def case_text(text, name="case.toml"):
    def raised(place):
        (place / name).write_text(text)
        Case(place / name)

    return raised


def placed(place):
    at = {flank: {"file": trace(), "at": {"roll_length": length}} for flank, length in (("pinion", "12 mm"), ("wheel", "21.126 mm"))}
    Case(small(surface={"cutoff": "0.25 mm", **at})).run()


def coarse(place):
    rough = asperity.Profile(heights(500) * 1e-6, 20e-6)
    surface = {"cutoff": "0 mm", "noise_cutoff": "0 um", "pinion": rough, "wheel": rough}
    Case(small(surface=surface)).run()


def existing(place):
    (place / "notes").mkdir()
    (place / "notes" / "diary.txt").write_text("12 March: wear")
    Case(small()).run(band=False).write(place / "notes")


def thin(place):
    # An Eyring stress of a pascal leaves no oil that a time step could be solved with.
    asperity.ehl(Case(small()), 0.25, cells=64, half_widths=1, start=0, eyring_stress="1 Pa")


GAP = np.linspace(-1, 1, 401) ** 2 * 1e-5


def values(**changed):
    return lambda place: Case(small(**changed)).run("losses")


def with_table(text):
    def raised(place):
        (place / "losses.csv").write_text(text)
        Case(small(gearbox={"loss_table": str(place / "losses.csv")})).run("losses")

    return raised


def two_teeth(place):
    flanks = {"pinion": {"traces": [trace(), trace(5990)]}, "wheel": {"file": trace()}}
    Case(small(surface={"cutoff": "0.25 mm", **flanks})).contact()


def averaged(place):
    # Every line is the one before it, shifted: their mean has no roughness.
    lines = np.concatenate([np.roll(heights(6060), 50 * line)[:6000] for line in range(8)])
    text = sdf(6000, 8)
    begin, end = text.index("*\n") + 2, text.rindex("\n*\n*")
    (place / "flank.sdf").write_text(text[:begin] + "\n".join(f"{z:.4f}" for z in lines) + text[end:])
    Case(small(surface={"cutoff": "0.25 mm", "pinion": {"file": str(place / "flank.sdf"), "line": "mean"}, "wheel": {"file": trace()}}))


BARE = {"cutoff": "0.25 mm", "pinion": {"rq": "0.3 um"}, "wheel": {"rq": "0.3 um"}}

RAISES = {
    "E101": read(with_row(40, "20.0,O.431")),
    "E102": read("Dear Sir,\nthe flank is fine.\n"),
    "E103": lambda place: asperity.read_profile(place / "absent.csv"),
    "E104": read("x,z\n" + rows(1000, lambda i, z: f"{0.5 * i:.1f},{1e4 * z:.1f}")),
    "E105": read(with_row(500, "1.0,0.1")),
    "E106": lambda place: asperity.Profile(heights(50), 1e-6),
    "E107": read(with_row(77, "38.5,NaN")),
    "E108": read(bytes([0, 159, 3, 200, 0, 1, 7, 255, 0, 12, 0, 0, 9, 130, 4]), "noise.dat"),
    "E109": read(with_row(500, "250.3,0.1")),
    "E110": read(rows(1000, lambda i, z: f"{z:.5f}"), z_unit="um"),
    "E111": read(with_row(50, "25.0,0.1,9")),
    "E112": read("a,b,c\n" + rows(500, lambda i, z: f"{i},{z:.4f},{z:.4f}")),
    "E113": read(rows(500, lambda i, z: f"{i},5,0,{int(100 * abs(z))}")),
    "E114": read(waves(500, "x [um],z [V]\n")),
    "E115": read(rows(500, lambda i, z: f"{i},5,0,{int(100 * abs(z))}"), decimal="comma"),
    "E116": lambda place: asperity.Profile(heights(500), -1e-6),
    "E117": read(sdf(900, 1), "cut.sdf"),
    "E118": huge,
    "E119": read(sdf(250, 2), "two.sdf"),
    "E120": read(waves(200)),
    "E121": coarse,
    "E122": values(model={"positions": 4, "offsets": 2, "window": 99}),
    "E123": placed,
    "E130": read("roll length [mm],z [um]\n" + rows(2000, lambda i, z: f"{8 + 0.002 * i:.4f},{z:.5f}")),
    "E131": None,  # below: the reader warns, the case refuses
    "E132": None,  # test_surface.py
    "E133": None,  # test_surface.py
    "E136": read("x_um,z_um\n" + rows(1000, lambda i, z: f"{0.5 * i + 20 * (i > 500):.1f},{z:.5f}"), uneven="resample"),
    "E139": read(waves(1000), range="0 mm .. 9 mm"),
    "E137": lambda place: Case(small(surface={"cutoff": "0.25 mm", "pinion": {"traces": str(place / "tooth*.csv")}, "wheel": {"file": trace()}})),
    "E138": with_table("speed_rpm,loss\n1,2\n"),
    "E201": lambda place: Case(place / "absent.toml"),
    "E202": case_text("gears = {"),
    "E203": lambda place: Case(small()).replace({"operation.torqe": "3 N m"}),
    "E204": lambda place: Case(small()).replace({"operation.torque": "145 N"}),
    "E205": lambda place: solve_contact(GAP, 1e-6, 115e9),
    "E206": lambda place: Case(small()).replace({"gears.profile_shift": [5, 5]}),
    "E207": lambda place: Case(small()).replace({"lubricant.pressure_viscosity": "2e-8 mm2/N"}),
    "E208": lambda place: Case(small()).replace({"lubricant.base_oil": None}),
    "E209": lambda place: solve_contact(GAP, 1e-6, -115e9, 1e5),
    "E211": lambda place: solve_contact(GAP, 1e-6, 115e9, 1e5, tolerance=1e-2),
    "E212": lambda place: Case(small()).replace({"gears.module": "1.8 m"}),
    "E220": lambda place: Case(small()).replace({"material.pinion.steel": "16MnCr6"}),
    "E222": values(gearbox={"seals": [{"name": "input", "shaft": "pinion", "diameter": "-40 mm"}]}),
    "E223": lambda place: Case(small(surface={**BARE, "finish": "honed"})),
    "E301": lambda place: solve_contact(GAP, 1e-6, 115e9, 1e5, tolerance=1e-17),
    "E302": lambda place: solve_contact(GAP, 1e-6, 115e9, 1e6, pressure_limit="1 GPa"),
    "E303": lambda place: Case(small(surface=BARE), formulation="paper").contact(),
    "E304": lambda place: Case(small(paper={"numerical_error": "1e-13 %"}), formulation="paper").run(),
    "E305": values(
        operation={"torque": "145 N m", "speed": "9000 1/min", "bulk_temperature": "240 °C"},
        model={"positions": 4, "offsets": 2, "film_friction": "xu"},
    ),
    "E306": values(material={"pinion": {"flow_pressure": "100 MPa"}}),
    "E307": thin,
    "E308": values(
        operation={"torque": "40 kN m", "speed": "9000 1/min", "bulk_temperature": "90 °C"},
        model={"positions": 4, "offsets": 2},
    ),
    "E311": values(
        operation={
            "torque": "145 N m",
            "speed": "9000 1/min",
            "oil_temperature": "60 °C",
            "bulk": {"law": "network", "pinion_to_oil": "0.1 W/K", "wheel_to_oil": "0.1 W/K"},
        },
    ),
    "E312": two_teeth,
    "E313": with_table("speed_rpm,loss_torque_nm\n100,1\n200,1\n"),
    # Curves of oils: test_oil.py.
    "E314": None,  # test_surface.py
    "E317": None,
    "E318": None,
    "E319": None,
    "E140": None,  # test_case.py
    "E141": averaged,
    "E143": lambda place: asperity.profile_change(PROFILES / "ground_pinion.csv", PROFILES / "ground_wheel.csv"),
    "E320": read(digital_surf_image(), "image.sur"),
    "E321": read(matlab_arrays(b"left", b"right"), "two.mat"),
    "E322": None,  # test_oil.py
    "E323": None,  # test_surface.py
    "E401": existing,
    "E402": lambda place: asperity.read_result(place),
}

# No function of the module can raise these.
ELSEWHERE = {
    "E134": "calibration is done by the command",
    "E135": "calibration is done by the command",
    "E210": "explain gives none for a code that does not exist",
    "E213": "the module has no command line",
    "E309": "shards are merged by the command",
    "E310": "calibration is done by the command",
    "E315": "calibration is done by the command",
    "E316": "calibration is done by the command",
    "E501": "faults of the program, which no input raises",
    "E502": "what cancels a call is raised itself, KeyboardInterrupt for instance",
}


@pytest.mark.parametrize("code", [code for code, raise_it in RAISES.items() if raise_it])
def test_a_code_is_raised_with_its_help(code, tmp_path):
    with pytest.raises(AsperityError) as raised:
        RAISES[code](tmp_path)
    error = raised.value
    assert error.code == code, str(error)
    assert error.message and error.help.endswith(".") and str(error).startswith(f"{code} ")
    assert "--" not in error.help, "an option of the command"


def test_e131_heights_that_no_flank_has(tmp_path):
    (tmp_path / "high.csv").write_text("x_um,z_mm\n" + rows(6000, lambda i, z: f"{0.5 * i:.1f},{z:.5f}"))
    with pytest.raises(AsperityError) as raised:
        Case(small(surface={"cutoff": "0.25 mm", "pinion": {"file": str(tmp_path / "high.csv")}}))
    assert raised.value.code == "E131" and raised.value.help
    assert raised.value.place.key == "surface.pinion.file"


def test_every_code_has_its_help():
    codes = vars(_asperity.Code)
    assert len(codes) > 100 and all(name == code for name, code in codes.items())
    for code in codes:
        error = AsperityError("m", code)
        assert error.help.endswith("."), code
        assert "--" not in error.help, "an option of the command"


def test_every_code_is_raised_or_belongs_to_the_command():
    known = {code for code in vars(_asperity.Code) if code.startswith("E")}
    assert known <= set(RAISES) | set(ELSEWHERE)
    assert set(RAISES) <= known


def test_an_error_is_a_value_error_with_its_actions():
    with pytest.raises(ValueError) as raised:
        solve_contact(GAP, 1e-6, 115e9, 1e6, pressure_limit=1e9)
    keys = [key for action in raised.value.actions if action["kind"] == "set" for key in action["settings"]]
    assert keys, raised.value.actions
    assert asperity.explain("E302").title == "the surface is too soft for the load"
    assert asperity.explain("X1") is None


def test_bad_arguments_are_told_apart():
    with pytest.raises(AsperityError, match="one dimension"):
        solve_contact(np.zeros((3, 3)), 1e-6, 115e9, 1e5)
    with pytest.raises(AsperityError, match="array of numbers"):
        solve_contact(["a", "b"], 1e-6, 115e9, 1e5)
    with pytest.raises(AsperityError, match="boundary: unknown variant `open`, expected one of `free`, `periodic`"):
        solve_contact(GAP, 1e-6, 115e9, 1e5, boundary="open")
    with pytest.raises(AsperityError, match="detail"):
        Case(small()).run("everything")
    with pytest.raises(AsperityError, match="at least two"):
        asperity.compare(CASES / "e-drive.toml", {"one": PROFILES / "superfinished.csv"})
    with pytest.raises(AsperityError, match="is not a Length"):
        asperity.Profile(heights(200), None)
    with pytest.raises(AsperityError, match="position 2"):
        Case(small()).contact(2.0)


def test_a_wrong_name_or_number_is_told_by_what_was_called(case):
    with pytest.raises(TypeError, match=r"^Profile.prepare\(\) got an unexpected keyword argument 'cuttoff'$"):
        trace().prepare(cuttoff=1)
    recipe = {"points": 2000, "spacing": 0.5e-6, "rq": 0.4e-6, "hurst": 0.8, "roll_off": 20e-6, "short_cut": 2e-6, "seed": 1}
    for wrong, code, words in (({"hurst": 1.5}, "E209", "hurst = 1.5: must lie"), ({"rq": 0.4}, "E209", "rq = 0.4 m"), ({"points": 50}, "E106", "50 points")):
        with pytest.raises(AsperityError, match=words) as refused:
            asperity.generate(**{**recipe, **wrong})
        assert refused.value.code == code and "filter" not in refused.value.help
    with pytest.raises(AsperityError, match="missing field `points`\n"):
        asperity.generate("fitted")
    with pytest.raises(AsperityError, match='Did you mean "m100"') as refused:
        case.replace({"lubricant.oil": "m1000"})
    assert repr(refused.value).startswith("AsperityError(E208 ") and "[{" not in repr(refused.value)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda case: asperity.Case(5), "case: the path of a case file"),
        (lambda case: asperity.map(3.0), "case: a Case"),
        (lambda case: case.replace(["operation.torque"]), "changed: keys of a case"),
        (lambda case: case.run("losses", threads="all"), "threads: a number"),
        (lambda case: asperity.sensitivity(case, threads=2.5), "threads: a number"),
        (lambda case: asperity.compare(case, [trace(), trace()]), "finishes: profiles"),
        (lambda case: asperity.compare(case, {"a": 1, "b": 2}), "finishes['a']: a profile"),
        (lambda case: asperity.compare(case, {"a": trace(), "b": trace()}, offsets="many"), "offsets"),
        (lambda case: asperity.cycle(3, "cycle.csv"), "map: a Map"),
        (lambda case: asperity.calibrate(3, case), "rig: a file"),
        (lambda case: asperity.oil_fit(3, "m100"), "curves: a file"),
        (lambda case: asperity.press_flanks(trace(), 2, radius=1e-2, load=1e5, modulus=1e11), "second: a Profile"),
        (lambda case: asperity.solve_contact("gap", 1e-6, 1e11), "gap: an array of numbers"),
        (lambda case: asperity.read_profile(3), "path: a path"),
        (lambda case: case.run("losses").diff(3), "other: a RunResult"),
        (lambda case: case.run().fields("first"), "position: a number"),
        (lambda case: case.contact("middle"), "position: a number"),
        (lambda case: asperity.sweep(case, {"torque_nm": 3}), "axes['torque_nm']: a list"),
        (lambda case: asperity.sweep(case, ["torque_nm"]), "axes: keys"),
        (lambda case: case.run("losses", progress=5), "progress: a function"),
        (lambda case: case.run(band="yes"), "band: True or False"),
        (lambda case: trace().parameters(sections="five"), "sections: a number without decimals"),
        (lambda case: trace().parameters(cutoff=[1, 2]), "cutoff: [1, 2] is not a Length"),
        (lambda case: trace().prepare(cutoff="0.25"), "cutoff: "),
        (lambda case: trace().prepare(ends="cut off"), "ends: unknown variant `cut off`, expected one of `cut`"),
        (lambda case: asperity.callout(case, "600 W", lots="many"), 'lots: invalid type: string "many", expected a whole number, 0 or more'),
        (lambda case: asperity.compare(case, {"hot": {"temperature": "120 °C"}}, offsets=2.5), "offsets: invalid type: floating point `2.5`, expected a whole number, 0 or more"),
        (lambda case: asperity.ehl(case, cells="many"), 'cells: invalid type: string "many", expected a whole number, 0 or more'),
        (lambda case: asperity.solve_contact(GAP, 1e-6, 1e11, 1e5, tolerance="low"), 'tolerance: invalid type: string "low", expected a number'),
        (lambda case: asperity.subsurface_stress([1e9] * 9, 1e-6, [0.0], poisson="0.3 mm"), "poisson: a number"),
        (lambda case: asperity.read_profile("flank.csv", columns="xz"), "columns: a number without decimals"),
        (lambda case: asperity.generate("groud"), "surface: unknown variant `groud`"),
        (lambda case: asperity.generate(points=8000, spacing=0.5e-6, rq=0.4e-6, hurst="low", roll_off=50e-6, short_cut=2e-6, seed=1), "hurst: "),
        (lambda case: asperity.generate(points=8000, height=3), "expected one of `points`, `spacing`, `rq`, `hurst`, `roll_off`"),
        (lambda case: asperity.generate_like(trace(), seed=-1), "seed: invalid value: integer `-1`, expected a whole number, 0 or more"),
        (lambda case: asperity.generate_like(trace(), after={"1e4": trace()}, engagements=1), "after: traces by engagements that are numbers"),
    ],
)
def test_an_argument_of_another_kind_is_named_with_what_it_takes(case, call, words):
    with pytest.raises(AsperityError) as refused:
        call(case)
    assert refused.value.code == "E204" and words in refused.value.message


@pytest.mark.parametrize("key", ["surface.pinion", "surface.pinion.file", "operation.torque", "torque", "gears.teeth", "model.positions"])
@pytest.mark.parametrize("kind", ["series", "frame", "dataarray", "array", "list", "set", "complex", "bytes", "timestamp", "object"])
def test_a_key_takes_no_value_of_another_kind(case, key, kind):
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    value = {
        "series": trace().to_pandas(), "frame": trace().to_pandas().to_frame(), "dataarray": xarray.DataArray(heights(6000)),
        "array": heights(6000), "list": heights(6000).tolist(), "set": {1, 2}, "complex": 1j, "bytes": b"x",
        "timestamp": pandas.Timestamp("2026-01-01"), "object": object(),
    }[kind]
    for call in (lambda: case.replace({key: value}), lambda: asperity.sweep(case, {key: [value]})):
        with pytest.raises(AsperityError) as refused:
            call()
        assert refused.value.code == "E204" and len(str(refused.value)) < 700
        if key.startswith("surface") and kind in ("array", "list"):
            assert "surface.pinion as asperity.Profile(heights, spacing)" in refused.value.help


@pytest.mark.parametrize(
    "call",
    [
        lambda case: asperity.callout(case, "600 W", confidence={1}),
        lambda case: asperity.callout(case, "600 W", lots=1j),
        lambda case: asperity.ehl(case, cells=b"128"),
        lambda case: asperity.generate(points={4000}, spacing=0.5e-6, rq="0.4 um", hurst=0.8, roll_off=50e-6, short_cut=2e-6, seed=1),
        lambda case: asperity.solve_contact(GAP, 1e-6, 1e11, 1e5, tolerance=1j),
        lambda case: asperity.friction_coefficient("constant", settings={"constant": 1j}),
        lambda case: asperity.sweep(case, {"torque_nm": [20]}, sample={"method": b"sobol"}),
        lambda case: trace().filter(robust={1}),
        lambda case: asperity.oil_fit(asperity.oil_traction("m100"), "m100"),
        lambda case: asperity.cycle(asperity.map(case, torque_nm=[50, 145], speed_rpm=[1000, 9000], band="none"), {"time_s": 1.0, "torque_nm": [1]}),
    ],
)
def test_a_setting_of_another_kind_is_no_error_of_json(case, call):
    with pytest.raises(AsperityError) as refused:
        call(case)
    assert refused.value.code == "E204" and refused.value.help


def test_settings_take_numbers_of_numpy():
    assert len(asperity.generate(points=np.int64(4000), spacing=np.float32(0.5e-6), rq="0.4 um", hurst=0.8, roll_off=50e-6, short_cut=2e-6, seed=np.int64(1))) == 4000
