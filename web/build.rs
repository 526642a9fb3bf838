//! What SQLite asks of its host (the time, random numbers) the page gives it.

fn main() {
    let is_page = std::env::var("CARGO_CFG_TARGET_FAMILY").is_ok_and(|family| family == "wasm");
    if is_page {
        println!("cargo::rustc-link-arg-cdylib=--allow-undefined");
    }
    println!("cargo::rerun-if-changed=build.rs");
}
