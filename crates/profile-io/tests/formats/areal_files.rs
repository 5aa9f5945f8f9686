//! A file of every areal format, made in memory: a surface of 120 columns and 3 rows.

use std::io::Write;

use flate2::Compression;
use flate2::write::ZlibEncoder;

pub const COLUMNS: usize = 120;
pub const ROWS: usize = 3;
/// Whole number of nanometres of a point; rows differ in height and shape.
pub fn nanometres(column: usize, row: usize) -> i32 {
    (600.0 * (0.37 * column as f64 + row as f64).sin()).round() as i32 + 100 * row as i32
}

/// A point without a height.
pub const HOLE: (usize, usize) = (7, 1);

pub fn is_hole(column: usize, row: usize) -> bool {
    (column, row) == HOLE
}

/// All points row by row, as `one` writes them.
pub fn points(one: impl Fn(usize, usize) -> Vec<u8>) -> Vec<u8> {
    let row = |y| (0..COLUMNS).map(move |x| (x, y));
    (0..ROWS)
        .flat_map(row)
        .flat_map(|(x, y)| one(x, y))
        .collect()
}

/// Bytes that are set at places.
pub fn filled(length: usize, parts: &[(usize, &[u8])]) -> Vec<u8> {
    let mut bytes = vec![0; length];
    for (at, part) in parts {
        bytes[*at..at + part.len()].copy_from_slice(part);
    }
    bytes
}

pub fn zlib(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// Digital Surf: nanometres as whole numbers over 0.5 um and 2 um.
pub fn sur(kind: i16, compressed: bool) -> Vec<u8> {
    let least = -2000_i32;
    let mark: &[u8] = if compressed {
        b"DSCOMPRESSED"
    } else {
        b"DIGITAL SURF"
    };
    let rows = if kind == 1 { 1 } else { ROWS as i32 };
    let mut header = filled(
        512,
        &[
            (0, mark),
            (14, &1_i16.to_le_bytes()),
            (16, &1_i16.to_le_bytes()),
            (18, &kind.to_le_bytes()),
            (20, b"flank 7"),
            (86, &1_i16.to_le_bytes()),
            (98, &32_i16.to_le_bytes()),
            (100, &least.to_le_bytes()),
            (104, &2000_i32.to_le_bytes()),
            (108, &(COLUMNS as i32).to_le_bytes()),
            (112, &rows.to_le_bytes()),
            (116, &(COLUMNS as i32 * rows).to_le_bytes()),
            (120, &0.5_f32.to_le_bytes()),
            (124, &2.0_f32.to_le_bytes()),
            (128, &1.0_f32.to_le_bytes()),
            (180, b"\xb5m"),
            (196, b"\xb5m"),
            (212, b"nm"),
            (228, b"\xb5m"),
            (244, b"\xb5m"),
            (260, b"nm"),
            (276, &1.0_f32.to_le_bytes()),
            (280, &1.0_f32.to_le_bytes()),
            (284, &1.0_f32.to_le_bytes()),
            (312, &20_i16.to_le_bytes()),
            (314, &11_i16.to_le_bytes()),
            (316, &2026_i16.to_le_bytes()),
            (334, &5_i16.to_le_bytes()),
            (336, &3_i16.to_le_bytes()),
        ],
    );
    header.extend(b"notesabc");
    let all = points(|x, y| {
        let value = if is_hole(x, y) {
            least - 2
        } else {
            nanometres(x, y)
        };
        value.to_le_bytes().to_vec()
    });
    let all = &all[..COLUMNS * rows as usize * 4];
    if !compressed {
        return [header, all.to_vec()].concat();
    }
    let halves = [&all[..all.len() / 2], &all[all.len() / 2..]];
    let packed = halves.map(zlib);
    let size = 4 + packed
        .iter()
        .map(|packed| 8 + packed.len() as u32)
        .sum::<u32>();
    header[324..328].copy_from_slice(&size.to_le_bytes());
    header.extend(2_u32.to_le_bytes());
    for (half, packed) in halves.iter().zip(&packed) {
        header.extend((half.len() as u32).to_le_bytes());
        header.extend((packed.len() as u32).to_le_bytes());
    }
    [header, packed.concat()].concat()
}

/// Alicona: metres as floats, rows padded to eight bytes.
pub fn al3d() -> Vec<u8> {
    let tag = |name: &str, value: &str| {
        filled(
            52,
            &[(0, name.as_bytes()), (20, value.as_bytes()), (50, b"\r\n")],
        )
    };
    let columns = COLUMNS.to_string();
    let rows = ROWS.to_string();
    let tags = [
        ("Version", "1"),
        ("TagCount", "6"),
        ("Cols", &columns),
        ("Rows", &rows),
        ("DepthImageOffset", "500"),
        ("InvalidPixelValue", "3.000000028082e+15"),
        ("PixelSizeXMeter", "5e-7"),
        ("PixelSizeYMeter", "2e-6"),
    ];
    let mut bytes = b"AliconaImaging\0\r\n".to_vec();
    bytes.extend(tags.iter().flat_map(|(name, value)| tag(name, value)));
    bytes.resize(500, 0);
    bytes.extend(points(|x, y| {
        let value = if is_hole(x, y) {
            3e15_f32
        } else {
            nanometres(x, y) as f32 * 1e-9
        };
        value.to_le_bytes().to_vec()
    }));
    bytes
}

/// Keyence VK4: nanometres over 3000 as whole numbers, in picometres.
pub fn vk4() -> Vec<u8> {
    let image = 400_usize;
    let size = (COLUMNS * ROWS * 2) as u32;
    let lengths = [500_000_u32, 2_000_000, 1000].map(u32::to_le_bytes);
    let mut bytes = filled(
        image + 28 + 768,
        &[
            (0, b"VK4_"),
            (12, &84_u32.to_le_bytes()),
            (36, &(image as u32).to_le_bytes()),
            (84 + 4, &2026_u32.to_le_bytes()),
            (84 + 8, &11_u32.to_le_bytes()),
            (84 + 12, &20_u32.to_le_bytes()),
            (84 + 168, &lengths[0]),
            (84 + 172, &lengths[1]),
            (84 + 176, &lengths[2]),
            (image, &(COLUMNS as u32).to_le_bytes()),
            (image + 4, &(ROWS as u32).to_le_bytes()),
            (image + 8, &16_u32.to_le_bytes()),
            (image + 16, &size.to_le_bytes()),
        ],
    );
    bytes.extend(points(|x, y| {
        ((nanometres(x, y) + 3000) as u16).to_le_bytes().to_vec()
    }));
    bytes
}

/// Keyence VK6: a picture, and a zip with a VK4.
pub fn vk6() -> Vec<u8> {
    let zip = super::samples::zip(&[("Vk4File", &vk4())]);
    [b"VK6\x10\0\0\0BM and a picture".to_vec(), zip].concat()
}

/// Sensofar PLU: micrometres as floats.
pub fn plu() -> Vec<u8> {
    let mut bytes = filled(
        508,
        &[
            (0, b"Fri Mar 10 16:35:59 2023\0"),
            (132, b"flank 7"),
            (388, &(ROWS as u32).to_le_bytes()),
            (392, &(COLUMNS as u32).to_le_bytes()),
            (404, &0.5_f32.to_le_bytes()),
            (408, &2.0_f32.to_le_bytes()),
            (428, &3_u32.to_le_bytes()),
            (489, &[1]),
            (500, &(ROWS as u32).to_le_bytes()),
            (504, &(COLUMNS as u32).to_le_bytes()),
        ],
    );
    bytes.extend(points(|x, y| {
        let value = if is_hole(x, y) {
            1_000_001.0
        } else {
            nanometres(x, y) as f32 / 1e3
        };
        value.to_le_bytes().to_vec()
    }));
    // Least and largest height.
    bytes.extend([0; 8]);
    bytes
}

/// Sensofar PLUX.
pub fn plux() -> Vec<u8> {
    let index = format!(
        "<xml><GENERAL><DATE>10-03-2023</DATE><IMAGE_SIZE_X>{COLUMNS}</IMAGE_SIZE_X>\
         <IMAGE_SIZE_Y>{ROWS}</IMAGE_SIZE_Y><FOV_X>0.5</FOV_X><FOV_Y>2.0</FOV_Y></GENERAL>\
         <INFO><ITEM_0><NAME>Device</NAME><VALUE>S neox</VALUE></ITEM_0></INFO>\
         <LAYER_0><FILENAME_Z>LAYER_0.raw</FILENAME_Z></LAYER_0></xml>"
    );
    let heights = points(|x, y| {
        let value = if is_hole(x, y) {
            f32::NAN
        } else {
            nanometres(x, y) as f32 / 1e3
        };
        value.to_le_bytes().to_vec()
    });
    super::samples::zip(&[
        ("index.xml", index.as_bytes()),
        ("recipe.txt", b"<xml></xml>"),
        ("LAYER_0.raw", &heights),
    ])
}

/// Zygo MetroPro: nanometres as S·W·O/R, with 10 bytes of intensities before.
pub fn metropro(sign: i16) -> Vec<u8> {
    let wavelength = 32768.0 * 2e-9_f32;
    let mut bytes = filled(
        834 + 10,
        &[
            (0, b"\x88\x1b\x03\x6f"),
            (4, &1_u16.to_be_bytes()),
            (6, &834_u32.to_be_bytes()),
            (52, &5_u16.to_be_bytes()),
            (54, &1_u16.to_be_bytes()),
            (56, &1_u16.to_be_bytes()),
            (60, &10_u32.to_be_bytes()),
            (68, &(COLUMNS as u16).to_be_bytes()),
            (70, &(ROWS as u16).to_be_bytes()),
            (80, b"flank 7"),
            (164, &0.5_f32.to_be_bytes()),
            (168, &wavelength.to_be_bytes()),
            (176, &1.0_f32.to_be_bytes()),
            (184, &0.5e-6_f32.to_be_bytes()),
            (218, &1_i16.to_be_bytes()),
            (230, &sign.to_be_bytes()),
        ],
    );
    bytes.extend(points(|x, y| {
        let value = if is_hole(x, y) {
            2_147_483_640
        } else {
            nanometres(x, y)
        };
        value.to_be_bytes().to_vec()
    }));
    bytes
}

/// Zygo XYZ: micrometres by pixels that are counted from (12, 8), each with its place.
pub fn zygo_xyz() -> Vec<u8> {
    let head = [
        "Zygo XYZ Data File - Format 1",
        "0 0 0 0 \"Mon Nov 02 10:00:00 2026\"",
        "0 0 120 3 1 255",
        &format!("12 8 {COLUMNS} {ROWS}"),
        "\"flank 7\"",
        "\"\"",
        "\"\"",
        "0 0.5 6.328e-07 0 1 0 5e-07 1793000000",
        "1 0 0 0 0 0 \"\"",
        "#\n",
    ]
    .join("\n");
    let one = |x: usize, y: usize| {
        let height = if is_hole(x, y) {
            "No Data".to_owned()
        } else {
            format!("{:.3}", um(x, y))
        };
        format!("{} {} {height}\n", x + 12, y + 8).into_bytes()
    };
    [head.into_bytes(), points(one), b"#\n".to_vec()].concat()
}

/// Zygo ASCII: intensities, then phases of a nanometre, ten to a line.
pub fn zygo_text() -> Vec<u8> {
    let head = [
        "Zygo ASCII Data File - Format 2",
        "1 8 3 5 \"Mon Mar 04 10:00:00 2019\"",
        "0 0 2 2 1 255",
        &format!("0 0 {COLUMNS} {ROWS}"),
        "\"flank 7\"",
        "\"\"",
        "\"\"",
        "0 0.5 6.5536e-05 0 1 0 5e-07 1551693600",
        "120 3 0 0 0 0 \"\"",
        "0 0 0 0 0 0 0 0.0 0 0",
        "1 1 20 2 0 0 0 0 0",
        "0 \"\"",
        "1 0",
        "\"\"",
        "#\n1 2 3\n4\n#\n",
    ]
    .join("\n");
    let one = |x: usize, y: usize| {
        let phase = if is_hole(x, y) {
            2_147_483_640
        } else {
            nanometres(x, y)
        };
        let end = if x % 10 == 9 { "\n" } else { " " };
        format!("{phase}{end}").into_bytes()
    };
    [head.into_bytes(), points(one), b"#\n".to_vec()].concat()
}

/// Wyko ASCII: waves, a line for each column from the last row up, and intensities after them.
pub fn wyko_text(in_nanometres: bool) -> Vec<u8> {
    let head = [
        &format!(
            "Wyko ASCII Data File Format 0\t{}\t1",
            u8::from(in_nanometres)
        ),
        &format!("X Size\t{COLUMNS}"),
        &format!("Y Size\t{ROWS}"),
        "Block Name\tType\tLength\tValue",
        "Pixel_size\t7\t4\t0.0005",
        "Aspect\t7\t4\t4",
        "Wavelength\t7\t4\t632.8",
        "Mult\t6\t2\t1000",
        "Title\t5\t20\tflank 7",
        "RAW_DATA\t3\t1440\n",
    ]
    .join("\n");
    let height = |x: usize, y: usize| match is_hole(x, y) {
        true => "Bad".to_owned(),
        false if in_nanometres => nanometres(x, y).to_string(),
        false => format!("{:.9}", f64::from(nanometres(x, y)) / 632.8 * 1000.0),
    };
    let column = |x: usize| {
        (0..ROWS)
            .rev()
            .map(|y| height(x, y))
            .collect::<Vec<_>>()
            .join("\t")
    };
    let heights: Vec<String> = (0..COLUMNS).map(column).collect();
    let intensities = format!("\nIntensity\t6\t720\n{}", "128\t128\t128\n".repeat(COLUMNS));
    (head + &heights.join("\n") + &intensities).into_bytes()
}

/// Gwyddion Simple Field: metres in floats.
pub fn gsf() -> Vec<u8> {
    let head = format!(
        "Gwyddion Simple Field 1.0\nXRes = {COLUMNS}\nYRes = {ROWS}\nXReal = 6e-05\nYReal = 6e-06\nXYUnits = m\nZUnits = m\nTitle = flank 7\n"
    );
    let mut bytes = head.into_bytes();
    bytes.resize((bytes.len() / 4 + 1) * 4, 0);
    bytes.extend(points(|x, y| {
        (um(x, y) as f32 * 1e-6).to_le_bytes().to_vec()
    }));
    bytes
}

/// Code V: nanometres as whole numbers, ten to a line.
pub fn code_v() -> Vec<u8> {
    let head =
        format!("! exported\nflank 7\nGRD {COLUMNS} {ROWS} SUR WVL 1.0 SSZ 1000 NDA 32767 XSC 1\n");
    let one = |x: usize, y: usize| {
        let number = if is_hole(x, y) {
            32767
        } else {
            nanometres(x, y)
        };
        let end = if x % 10 == 9 { "\n" } else { " " };
        format!("{number}{end}").into_bytes()
    };
    [head.into_bytes(), points(one)].concat()
}

/// Wyko OPD: nanometres in floats, column by column from the last row up.
pub fn opd() -> Vec<u8> {
    let column = |x| (0..ROWS).rev().map(move |y| (x, y));
    let mut heights = Vec::new();
    for size in [COLUMNS as u16, ROWS as u16, 4] {
        heights.extend(size.to_le_bytes());
    }
    for (x, y) in (0..COLUMNS).flat_map(column) {
        let value = if is_hole(x, y) {
            1e38_f32
        } else {
            nanometres(x, y) as f32 * 2.0
        };
        heights.extend(value.to_le_bytes());
    }
    let blocks: [(&str, u16, Vec<u8>); 6] = [
        ("Title", 5, b"flank 7\0".to_vec()),
        ("Wavelength", 7, 4.0_f32.to_le_bytes().to_vec()),
        ("Mult", 6, 8_u16.to_le_bytes().to_vec()),
        ("Pixel_size", 7, 0.5e-3_f32.to_le_bytes().to_vec()),
        ("Aspect", 7, 4.0_f32.to_le_bytes().to_vec()),
        ("RAW_DATA", 3, heights),
    ];
    let entry = |name: &str, kind: u16, size: usize| {
        let size = (size as u32).to_le_bytes();
        filled(
            24,
            &[
                (0, name.as_bytes()),
                (16, &kind.to_le_bytes()),
                (18, &size),
                (22, b"\xff\xff"),
            ],
        )
    };
    let mut bytes = vec![1, 0];
    bytes.extend(entry("Directory", 1, 24 * (blocks.len() + 1)));
    bytes.extend(
        blocks
            .iter()
            .flat_map(|(name, kind, data)| entry(name, *kind, data.len())),
    );
    bytes.extend(blocks.into_iter().flat_map(|(_, _, data)| data));
    bytes
}

/// Binary SDF of version 1 or 2: nanometres as whole numbers of 16 bits.
pub fn sdf_binary(wide: bool) -> Vec<u8> {
    let mut bytes: Vec<u8> = if wide { b"bISO-2.0" } else { b"bISO-1.0" }.to_vec();
    bytes.extend(b"maker\0junk201120261000201120261000");
    for count in [COLUMNS, ROWS] {
        if wide {
            bytes.extend((count as u32).to_le_bytes())
        } else {
            bytes.extend((count as u16).to_le_bytes())
        }
    }
    for scale in [0.5e-6, 2e-6, 1e-9, -1.0] {
        bytes.extend(f64::to_le_bytes(scale));
    }
    bytes.extend([0, 5, 0]);
    bytes.extend(points(|x, y| {
        let value = if is_hole(x, y) {
            i16::MIN
        } else {
            nanometres(x, y) as i16
        };
        value.to_le_bytes().to_vec()
    }));
    bytes
}

/// An element of a MAT-file.
fn element(kind: u32, data: &[u8]) -> Vec<u8> {
    let mut bytes = [kind, data.len() as u32].map(u32::to_le_bytes).concat();
    bytes.extend(data);
    bytes.resize(bytes.len().next_multiple_of(8), 0);
    bytes
}

/// An array of a MAT-file, its numbers in micrometres.
pub fn mat_array(
    name: &str,
    rows: usize,
    columns: usize,
    value: impl Fn(usize, usize) -> f64,
) -> Vec<u8> {
    let by_column = (0..columns).flat_map(|x| (0..rows).map(move |y| (x, y)));
    let numbers: Vec<u8> = by_column
        .flat_map(|(x, y)| value(x, y).to_le_bytes())
        .collect();
    let flags = [6_u32, 0].map(u32::to_le_bytes).concat();
    let sizes = [rows as i32, columns as i32].map(i32::to_le_bytes).concat();
    // A short name stands in its tag.
    let short = filled(
        8,
        &[(0, &[1, 0, name.len() as u8, 0]), (4, name.as_bytes())],
    );
    element(
        14,
        &[
            element(6, &flags),
            element(5, &sizes),
            short,
            element(9, &numbers),
        ]
        .concat(),
    )
}

/// A MAT-file of these arrays, the compressed ones as zlib streams.
pub fn mat(arrays: &[Vec<u8>], compressed: bool) -> Vec<u8> {
    let mut bytes = filled(
        128,
        &[
            (0, b"MATLAB 5.0 MAT-file, made for a test"),
            (124, b"\x00\x01IM"),
        ],
    );
    for array in arrays {
        if compressed {
            let packed = zlib(array);
            bytes.extend([15, packed.len() as u32].map(u32::to_le_bytes).concat());
            bytes.extend(packed);
        } else {
            bytes.extend(array)
        }
    }
    bytes
}

/// An item of an OPDx file.
fn item(name: &str, kind: u8, data: &[u8]) -> Vec<u8> {
    let mut bytes = (name.len() as u32).to_le_bytes().to_vec();
    bytes.extend(name.as_bytes());
    bytes.push(kind);
    bytes.extend(data);
    bytes
}

/// Data with their length before them.
fn counted(data: &[u8]) -> Vec<u8> {
    [&[4], &(data.len() as u32).to_le_bytes()[..], data].concat()
}

fn container(name: &str, items: &[Vec<u8>]) -> Vec<u8> {
    let inside = [items.concat(), item("", 0x7f, &[]), vec![0xff, 0xff]].concat();
    item(name, 0x7d, &counted(&inside))
}

fn name(text: &str) -> Vec<u8> {
    [&(text.len() as u32).to_le_bytes()[..], text.as_bytes()].concat()
}

fn quantity(called: &str, value: f64, unit: &str) -> Vec<u8> {
    let data = [value.to_le_bytes().to_vec(), name("a unit"), name(unit)].concat();
    item(called, 0x13, &counted(&data))
}

/// Bruker OPDx with the first row as a profile.
pub fn opdx() -> Vec<u8> {
    let heights: Vec<u8> = (0..COLUMNS)
        .flat_map(|x| f64::from(nanometres(x, 0)).to_le_bytes())
        .collect();
    let array = [name("array"), counted(&[vec![0; 5], heights].concat())].concat();
    let names = [name("list"), counted(&name("Raw"))].concat();
    let text = |text: &str| counted(text.as_bytes());
    let data = [
        item("DataKind", 0x12, &counted(b"Height")),
        item("NumPoints", 0x07, &(COLUMNS as u32).to_le_bytes()),
        quantity("Extent", 0.5 * (COLUMNS - 1) as f64, "\u{b5}m"),
        quantity("DataScale", 1e-3, "\u{b5}m"),
        item("Array", 0x40, &array),
    ];
    let meta = [
        item("DataKind", 0x12, &text("Surface Profile")),
        item("TimeStamp", 0x15, &[0; 9]),
        item("Date", 0x12, &text("20/11/2026")),
        container("1D_Channels", &[item("Height", 0x42, &names)]),
    ];
    let mark = b"VCA DATA\x01\x00\x00\x55".to_vec();
    let trees = [
        container("1D_Data", &[container("Raw", &data)]),
        container("MetaData", &meta),
        item("", 0x7f, &[]),
    ];
    [mark, trees.concat()].concat()
}

/// Nanosurf: a channel of forces, then the heights as 32-bit numbers in a range of 2^32 nm.
pub fn nid() -> Vec<u8> {
    let channel = |number: usize, name: &str, unit: &str| {
        format!(
            "[DataSet-0:{number}]\r\nPoints={COLUMNS}\r\nLines={ROWS}\r\nSaveBits=32\r\nSaveSign=Signed\r\n\
             Dim0Range=6e-05\r\nDim0Unit=m\r\nDim1Range=6e-06\r\nDim1Unit=m\r\n\
             Dim2Name={name}\r\nDim2Unit={unit}\r\nDim2Range=4.294967296\r\nDim2Min=-2.147483648\r\n\r\n"
        )
    };
    let mut bytes = format!(
        "[DataSet]\r\nVersion=2\r\nGroupCount=1\r\nGr0-Name=Scan forward\r\nGr0-Count=2\r\nGr0-Ch0=DataSet-0:0\r\n\
         Gr0-Ch1=DataSet-0:1\r\n\r\n{}{}#!",
        channel(0, "Deflection", "N"),
        channel(1, "Z-Axis", "m")
    )
    .into_bytes();
    bytes.extend(points(|_, _| vec![9; 4]));
    bytes.extend(points(|x, y| {
        let number = if is_hole(x, y) {
            i32::MIN
        } else {
            nanometres(x, y)
        };
        number.to_le_bytes().to_vec()
    }));
    bytes
}

/// Igor wave: two layers of floats, of which the second is the height in metres.
pub fn ibw() -> Vec<u8> {
    let labels = ["", "DeflectionRetrace", "HeightRetrace"].map(|label| {
        let mut bytes = label.as_bytes().to_vec();
        bytes.resize(32, 0);
        bytes
    });
    let labels = labels.concat();
    let sides = [COLUMNS as i32, ROWS as i32, 2, 0];
    let sides: Vec<u8> = sides.iter().flat_map(|side| side.to_le_bytes()).collect();
    let steps: Vec<u8> = [0.5e-6_f64, 2e-6]
        .iter()
        .flat_map(|step| step.to_le_bytes())
        .collect();
    let mut bytes = filled(
        384,
        &[
            (0, &5_i16.to_le_bytes()),
            (44, &(labels.len() as i32).to_le_bytes()),
            (64 + 12, &((2 * COLUMNS * ROWS) as i32).to_le_bytes()),
            (64 + 16, &2_i16.to_le_bytes()),
            (64 + 28, b"flank"),
            (64 + 68, &sides),
            (64 + 84, &steps),
            (64 + 148, b"m"),
            (64 + 152, b"m"),
            (64 + 156, b"m"),
        ],
    );
    bytes.extend(points(|_, _| 7_f32.to_le_bytes().to_vec()));
    bytes.extend(points(|x, y| {
        ((um(x, y) / 1e6) as f32).to_le_bytes().to_vec()
    }));
    bytes.extend(labels);
    bytes
}

/// Gwyddion: a phase, then the heights in metres under a title.
pub fn gwy() -> Vec<u8> {
    let text = |text: &str| [text.as_bytes(), &[0]].concat();
    let item = |name: &str, kind: u8, value: &[u8]| [&text(name), &[kind][..], value].concat();
    let object = |kind: &str, items: &[Vec<u8>]| {
        let items = items.concat();
        [&text(kind), &(items.len() as u32).to_le_bytes()[..], &items].concat()
    };
    let unit = |name: &str| object("GwySIUnit", &[item("unitstr", b's', &text(name))]);
    let field = |z_unit: &str| {
        let count = ((COLUMNS * ROWS) as u32).to_le_bytes().to_vec();
        let data = points(|x, y| (um(x, y) / 1e6).to_le_bytes().to_vec());
        object(
            "GwyDataField",
            &[
                item("xres", b'i', &(COLUMNS as i32).to_le_bytes()),
                item("yres", b'i', &(ROWS as i32).to_le_bytes()),
                item("xreal", b'd', &(0.5e-6 * COLUMNS as f64).to_le_bytes()),
                item("yreal", b'd', &(2e-6 * ROWS as f64).to_le_bytes()),
                item("si_unit_xy", b'o', &unit("m")),
                item("si_unit_z", b'o', &unit(z_unit)),
                item("data", b'D', &[count, data].concat()),
            ],
        )
    };
    let container = object(
        "GwyContainer",
        &[
            item("/0/data", b'o', &field("deg")),
            item("/1/data", b'o', &field("m")),
            item("/1/data/title", b's', &text("Topography")),
            item("/1/data/visible", b'b', &[1]),
        ],
    );
    [b"GWYP".to_vec(), container].concat()
}

/// A file of every kind, with its name.
pub fn all() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("a.sur", sur(2, false)),
        ("b.sur", sur(2, true)),
        ("a.al3d", al3d()),
        ("a.vk4", vk4()),
        ("a.vk6", vk6()),
        ("a.plu", plu()),
        ("a.plux", plux()),
        ("a.dat", metropro(0)),
        ("a.xyz", zygo_xyz()),
        ("b.asc", zygo_text()),
        ("a.asc", wyko_text(false)),
        ("a.opd", opd()),
        ("a.sdf", sdf_binary(false)),
        ("b.sdf", sdf_binary(true)),
        ("a.opdx", opdx()),
        ("a.mat", mat(&[mat_array("z", ROWS, COLUMNS, um)], true)),
        ("a.nid", nid()),
        ("a.ibw", ibw()),
        ("a.gwy", gwy()),
        ("a.gsf", gsf()),
    ]
}

/// Height of a point in micrometres.
pub fn um(column: usize, row: usize) -> f64 {
    if is_hole(column, row) {
        f64::NAN
    } else {
        f64::from(nanometres(column, row)) / 1e3
    }
}
