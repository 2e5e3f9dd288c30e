//! Finds the libraries of the features that are asked for; see README.md.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

fn main() {
    for name in ["ORBICUBE_LIBRARIES", "ORBICUBE_FROM_TREE", "PKG_CONFIG_PATH", "PKG_CONFIG_LIBDIR"] {
        println!("cargo:rerun-if-env-changed={name}");
    }
    if env::var_os("DOCS_RS").is_some() {
        return; // documentation is made without the libraries
    }
    // Every feature but the default one is a library.
    let features: Vec<String> = env::vars()
        .filter_map(|(name, _)| name.strip_prefix("CARGO_FEATURE_").map(str::to_lowercase))
        .filter(|name| name != "default")
        .collect();
    let wanted: Vec<&str> = features.iter().map(String::as_str).collect();
    if let Some(folders) = env::var_os("ORBICUBE_LIBRARIES") {
        for folder in env::split_paths(&folders) {
            println!("cargo:rustc-link-search=native={}", folder.display());
        }
        for name in wanted.iter().copied().chain(["base"]) {
            println!("cargo:rustc-link-lib=dylib={}", dashed(name));
        }
        return;
    }
    let tree = env::var_os("ORBICUBE_FROM_TREE").is_some();
    if !tree && asked(&wanted, None) {
        return;
    }
    // The published crate has the sources in it; in a clone they are around it.
    let here = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap());
    let roots = [here.join("vendor"), here.join("../../..")];
    let root = roots.into_iter().find(|root| root.join("capi/meson.build").exists()).unwrap_or_else(|| {
        panic!(
            "the Orbicube libraries {wanted:?} were found neither by pkg-config nor as sources in or around this crate; \
             name their folder in ORBICUBE_LIBRARIES"
        )
    });
    let prefix = built(&root, &wanted);
    if !asked(&wanted, Some(&prefix.join("lib/pkgconfig"))) {
        panic!("pkg-config is missing, or does not find what Meson has just installed to {}", prefix.display());
    }
}

fn dashed(name: &str) -> String {
    format!("orbicube-{}", name.replace('_', "-"))
}

/// Tells cargo what pkg-config says of the libraries; false when it knows one of them not. Those in `folder` are static.
fn asked(wanted: &[&str], folder: Option<&Path>) -> bool {
    let mut command = Command::new(env::var_os("PKG_CONFIG").unwrap_or_else(|| "pkg-config".into()));
    command.arg("--libs").args(wanted.iter().copied().chain(["base"]).map(dashed));
    if let Some(folder) = folder {
        // Before all others, among which is what these need (zlib).
        let others = env::var_os("PKG_CONFIG_PATH").unwrap_or_default();
        let folders = [folder.to_path_buf()].into_iter().chain(env::split_paths(&others));
        command.arg("--static").env("PKG_CONFIG_PATH", env::join_paths(folders).unwrap());
    }
    let output = match command.output() {
        Ok(output) => output,
        Err(_) => return false,
    };
    if !output.status.success() {
        return false;
    }
    for word in String::from_utf8_lossy(&output.stdout).split_whitespace() {
        if let Some(path) = word.strip_prefix("-L") {
            println!("cargo:rustc-link-search=native={path}");
        } else if let Some(name) = word.strip_prefix("-l") {
            let kind = if folder.is_some() && name.starts_with("orbicube-") { "static" } else { "dylib" };
            println!("cargo:rustc-link-lib={kind}={name}");
        }
    }
    true
}

/// Builds and installs the libraries of the tree, and answers where.
fn built(root: &Path, wanted: &[&str]) -> PathBuf {
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap());
    let (build, prefix) = (out.join("build"), out.join("prefix"));
    let mut setup = Command::new("meson");
    setup.arg("setup").arg(&build).arg(root).arg("--prefix").arg(&prefix);
    if build.join("build.ninja").exists() {
        setup.arg("--reconfigure");
    }
    setup.args(["--libdir", "lib", "-Ddefault_library=static", "-Dtests=false", "-Dexamples=false", "-Dcli=disabled"]);
    setup.arg(format!("-Dlibraries=base,{}", wanted.join(",")));
    run(&mut setup);
    let jobs = env::var("NUM_JOBS").unwrap_or_else(|_| "1".into());
    run(Command::new("ninja").args(["-j", &jobs, "-C"]).arg(&build));
    run(Command::new("meson").args(["install", "--no-rebuild", "-C"]).arg(&build));
    println!("cargo:rerun-if-changed={}", root.join("libs").display());
    println!("cargo:rerun-if-changed={}", root.join("capi").display());
    prefix
}

fn run(command: &mut Command) {
    match command.output() {
        Ok(output) if output.status.success() => {}
        Ok(output) => panic!(
            "{command:?} failed:\n{}\n{}",
            String::from_utf8_lossy(&output.stdout),
            String::from_utf8_lossy(&output.stderr)
        ),
        Err(error) => panic!(
            "{command:?}: {error}; building the Orbicube libraries requires Meson, ninja, pkg-config and a C++20 compiler"
        ),
    }
}
