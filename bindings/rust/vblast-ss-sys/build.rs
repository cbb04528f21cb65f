//! Finds the library: the folder in VBLAST_SS_LIB_DIR, else that of pkg-config, else the linker's own search.
use std::env;
use std::process::Command;

fn folder_of_pkg_config() -> Option<String> {
    let said = Command::new("pkg-config").args(["--variable=libdir", "vblast_ss"]).output().ok()?;
    let folder = String::from_utf8(said.stdout).ok()?.trim().to_string();
    (said.status.success() && !folder.is_empty()).then_some(folder)
}

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=VBLAST_SS_LIB_DIR");
    println!("cargo:rerun-if-env-changed=VBLAST_SS_STATIC");
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    if let Some(folder) = env::var("VBLAST_SS_LIB_DIR").ok().or_else(folder_of_pkg_config) {
        println!("cargo:rustc-link-search=native={folder}");
    }
    if env::var("VBLAST_SS_STATIC").map_or(false, |value| value == "1") {
        println!("cargo:rustc-link-lib=static=vblast_ss");
        if env::var("CARGO_CFG_TARGET_FAMILY").map_or(false, |family| family == "unix") {
            println!("cargo:rustc-link-lib=m");
        }
    } else {
        println!("cargo:rustc-link-lib=dylib=vblast_ss");
    }
}
