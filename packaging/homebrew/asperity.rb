# The command for macOS and Linux: a formula of a tap. OWNER and the checksums are those of the release (SHA256SUMS).
class Asperity < Formula
  desc "Mesh efficiency of a gear pair from the measured roughness of its tooth flanks"
  homepage "https://github.com/OWNER/asperity"
  version "0.1.0"
  license any_of: ["MIT", "Apache-2.0"]

  on_macos do
    on_arm do
      url "https://github.com/OWNER/asperity/releases/download/v#{version}/asperity-aarch64-apple-darwin.tar.gz"
      sha256 "SHA256"
    end
    on_intel do
      url "https://github.com/OWNER/asperity/releases/download/v#{version}/asperity-x86_64-apple-darwin.tar.gz"
      sha256 "SHA256"
    end
  end
  on_linux do
    on_arm do
      url "https://github.com/OWNER/asperity/releases/download/v#{version}/asperity-aarch64-unknown-linux-musl.tar.gz"
      sha256 "SHA256"
    end
    on_intel do
      url "https://github.com/OWNER/asperity/releases/download/v#{version}/asperity-x86_64-unknown-linux-musl.tar.gz"
      sha256 "SHA256"
    end
  end

  def install
    bin.install "asperity"
    man1.install "asperity.1"
    bash_completion.install "completions/asperity.bash" => "asperity"
    fish_completion.install "completions/asperity.fish"
    zsh_completion.install "completions/_asperity"
  end

  test do
    system bin/"asperity", "demo"
    assert_match "efficiency", shell_output("#{bin}/asperity run demo/case.toml")
  end
end
