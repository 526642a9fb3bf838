class Carrom < Formula
  desc "Terminal game that teaches glancing collisions"
  homepage "{{repository}}"
  url "https://static.crates.io/crates/carrom/carrom-{{version}}.crate"
  sha256 "{{sha256 carrom-{{version}}.crate}}"
  license any_of: ["MIT", "Apache-2.0"]

  depends_on "rust" => :build

  def install
    system "cargo", "install", *std_cargo_args
    generate_completions_from_executable(bin/"carrom", "completions")
    (man1/"carrom.1").write Utils.safe_popen_read(bin/"carrom", "man")
  end

  test do
    assert_match version.to_s, shell_output("#{bin}/carrom --version")
    assert_match "60.0", shell_output("#{bin}/carrom solve --alpha-deg 30")
  end
end
