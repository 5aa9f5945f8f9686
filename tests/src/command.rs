//! The `asperity` command, built with the features of the tests.

fn main() -> std::process::ExitCode {
    asperity_cli::main()
}
