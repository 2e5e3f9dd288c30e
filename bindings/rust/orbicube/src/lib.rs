//! Orbicube: maps of surfaces to spheres and polycubes, frame fields, meshes, and the solvers underneath. A module and a cargo
//! feature a library.
//!
//! ```
//! # #[cfg(feature = "trust_region")] {
//! use orbicube::trust_region;
//!
//! let mut x = [0.0, 0.0];
//! let report = trust_region::minimize(|x: &[f64]| (x[0] - 1.0).powi(2) + (x[1] + 2.0).powi(2), &mut x, &Default::default(),
//!                                     &Default::default())?;
//! assert!(report.converged() && (x[0] - 1.0).abs() < 1e-6);
//! # }
//! # Ok::<(), orbicube::Error>(())
//! ```
//!
//! Options and reports are the C structs behind `Deref`, with their defaults filled in: a member that a header gains is there
//! at once. Each function is described in the header of its library, which [`sys`] has as documentation; the C functions
//! can be called beside, through it.
//!
//! Threads: what may be read by several threads is `Sync`, what one thread uses at a time only `Send`.

pub use orbicube_sys as sys;

#[macro_use]
mod call;
pub use call::{Answer, Error, Evaluation, Host, Progress};

#[cfg(feature = "correspondence")]
pub mod correspondence;
#[cfg(feature = "frame_field")]
pub mod frame_field;
#[cfg(feature = "gltf")]
pub mod gltf;
#[cfg(feature = "harmonics")]
pub mod harmonics;
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
#[cfg(feature = "hexmesh")]
pub mod hexmesh;
#[cfg(feature = "volume_map")]
pub mod volume_map;
