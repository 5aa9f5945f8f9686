# Short names for the commands of the README and of .ci/run.

# The main job on the shipped e-drive stage.
run case="fixtures/cases/e-drive.toml":
    cargo run --release -- run {{ case }}

# The tests of the workspace, but the slow ones.
test:
    cargo test --workspace

# All tests, those of the dense reference solver among them, as every night.
test-all:
    cargo test --workspace --locked --features asperity-ehl/oracle
    cargo test --workspace --locked --features asperity-ehl/oracle --tests -- --ignored slow_

# Format, lint, tests, documentation: what must hold before a change lands.
ci:
    .ci/run

# Write the tables of docs/VALIDATION.md and other pages, and tests/golden/evidence.
validation:
    ASPERITY_WRITE=1 cargo test --workspace --test validation

# Independent numbers in Python, compared with what the tests and the constants hold; needs numpy, scipy and mpmath.
references python="python3":
    for script in table_2 half_plane rough_contact film_friction point_film load_map load_share swept smooth_film rough_inlet small_constants shakedown; do {{ python }} references/$script.py || exit 1; done

# Make all pictures of README and documents anew: the paper's figures, and those that tests take from pages or draw.
pictures:
    cargo run --release -- figures -o docs/figures
    ASPERITY_WRITE=1 cargo test -p asperity-tests --test cli --test validation -- --include-ignored picture

# Benches; the table of results is in docs/PERFORMANCE.md.
bench:
    cargo bench --manifest-path benches/Cargo.toml --target-dir target

# Make the synthetic profiles and cases in fixtures/ anew.
fixtures:
    cargo run --release -p asperity-fixtures

# Write the table of equations anew from the doc comments.
equations:
    ASPERITY_WRITE=1 cargo test -p asperity-tests --test equations the_table_has_the_formulas

# Build the book into target/book with mdBook and mdbook-katex; commands, messages, equations and Python are added.
book python="python3":
    .ci/book {{ python }}

# Build the page that runs in a browser; docs/WEB.md says how to serve it.
page folder="target/web":
    cargo run --locked --manifest-path crates/web/build/Cargo.toml -- {{ folder }}
