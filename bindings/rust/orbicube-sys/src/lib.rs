//! The C functions of the Orbicube libraries as they are, a module and a cargo feature a library, written from the C
//! headers by scripts/bindings.py. The documentation is that of the headers. People use the crate `orbicube`.

pub mod base;
#[cfg(feature = "correspondence")]
pub mod correspondence;
#[cfg(feature = "frame_field")]
pub mod frame_field;
#[cfg(feature = "gltf")]
pub mod gltf;
#[cfg(feature = "harmonics")]
pub mod harmonics;
#[cfg(feature = "hexmesh")]
pub mod hexmesh;
#[cfg(feature = "linear")]
pub mod linear;
#[cfg(feature = "mesh")]
pub mod mesh;
#[cfg(feature = "polycube")]
pub mod polycube;
#[cfg(feature = "projected_gradient")]
pub mod projected_gradient;
#[cfg(feature = "quaternion")]
pub mod quaternion;
#[cfg(feature = "repair")]
pub mod repair;
#[cfg(feature = "sphere_map")]
pub mod sphere_map;
#[cfg(feature = "sphere_optimizer")]
pub mod sphere_optimizer;
#[cfg(feature = "tetrahedra")]
pub mod tetrahedra;
#[cfg(feature = "trust_region")]
pub mod trust_region;
#[cfg(feature = "untangle")]
pub mod untangle;
#[cfg(feature = "volume_map")]
pub mod volume_map;
