//! The `asperity` command.

fn main() -> std::process::ExitCode {
    asperity_cli::main()
}
