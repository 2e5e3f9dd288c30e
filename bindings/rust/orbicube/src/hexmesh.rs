//! Hexahedral meshes of closed surfaces and of tetrahedral solids.
//!
//! ```
//! use orbicube::{hexmesh, mesh::Mesh, Host};
//! let cube = Mesh::make("cube", 300, 0, &mut Host::new())?;
//! let mut options = hexmesh::Options::default();
//! options.cells = 27;
//! let (hexes, report) = hexmesh::fill_with_hexahedra(cube.surface(), &options, &mut Host::new())?;
//! assert!(hexes.hexahedra.len() >= 27 && report.min_scaled_jacobian > 0.0);
//! # Ok::<(), orbicube::Error>(())
//! ```

use crate::call::{call, checked, expect_length, pointer, rows, Error, Host};
use crate::mesh::Surface;
use crate::sys::hexmesh::*;

filled!(/// Options, with their defaults. `fill` may be set to `sys::tetrahedra::obc_tetrahedra_fill_mesh`.
    Options, obc_hexmesh_options, obc_hexmesh_options_init);
sized!(/// What was made.
    Report, obc_hexmesh_report);
handle!(HexesHandle, obc_hexmesh, obc_hexmesh_destroy);

/// A corner or a curve of the surface that a mesh lacks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MissingFeature {
    pub corner: bool,
    /// The ends of the curve; twice the position of the corner.
    pub first: [f64; 3],
    pub last: [f64; 3],
    /// The fraction of the length of the curve that edges of the mesh follow.
    pub captured: f64,
    /// What was in the way.
    pub why: String,
}

/// A certified mesh of hexahedra.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hexes {
    pub positions: Vec<f64>,
    /// As MEDIT and VTK order their vertices.
    pub hexahedra: Vec<[u32; 8]>,
    /// Of the boundary, counter-clockwise seen from outside.
    pub quads: Vec<[u32; 4]>,
    /// Of the polycube, of the map along frames, or of embedded features: what each quad lies on.
    pub quad_patches: Vec<u32>,
    /// The number of the region that each hexahedron is in, 0 where the options have no regions.
    pub regions: Vec<i32>,
    /// Of the features that the options request.
    pub missing: Vec<MissingFeature>,
}

impl Hexes {
    fn taken(handle: HexesHandle) -> Result<Hexes, Error> {
        let out = handle.as_ptr();
        let mut hexes = Hexes::default();
        unsafe {
            hexes.positions.resize(3 * obc_hexmesh_vertex_count(out), 0.0);
            hexes.hexahedra.resize(obc_hexmesh_count(out), [0; 8]);
            hexes.quads.resize(obc_hexmesh_quad_count(out), [0; 4]);
            hexes.quad_patches.resize(hexes.quads.len(), 0);
            checked(|error| {
                obc_hexmesh_copy(out, hexes.positions.as_mut_ptr(), hexes.hexahedra.as_mut_ptr() as *mut u32,
                                          hexes.quads.as_mut_ptr() as *mut u32, hexes.quad_patches.as_mut_ptr(), error)
            })?;
            hexes.regions.resize(hexes.hexahedra.len(), 0);
            checked(|error| obc_hexmesh_copy_regions(out, hexes.regions.as_mut_ptr(), error))?;
            for index in 0..obc_hexmesh_missing_count(out) {
                let mut found: obc_hexmesh_missing = std::mem::zeroed();
                found.struct_size = std::mem::size_of::<obc_hexmesh_missing>() as u32;
                checked(|error| obc_hexmesh_get_missing(out, index, &mut found, error))?;
                let why = std::ffi::CStr::from_ptr(obc_hexmesh_missing_reason(out, index)).to_string_lossy().into_owned();
                hexes.missing.push(MissingFeature { corner: found.corner != 0, first: found.first, last: found.last,
                                                    captured: found.captured, why });
            }
        }
        Ok(hexes)
    }
}

/// Fills a closed surface with hexahedra.
pub fn fill_with_hexahedra(surface: Surface, options: &Options, host: &mut Host) -> Result<(Hexes, Report), Error> {
    let (mut out, mut report) = (std::ptr::null_mut(), Report::default());
    call(host, |host, error| unsafe {
        obc_hexmesh_compute(&surface.c, &options.0, host, &mut report.0, &mut out, error)
    })?;
    Ok((Hexes::taken(HexesHandle::own(out))?, report))
}

/// Fills a solid of tetrahedra with hexahedra. frames: w x y z a tetrahedron, which the hexahedra follow, or empty.
pub fn fill_solid_with_hexahedra(positions: &[f64], tetrahedra: &[u32], frames: &[f64], options: &Options,
                                 host: &mut Host) -> Result<(Hexes, Report), Error> {
    let (vertices, cells) = (rows(positions.len(), 3, "positions")?, rows(tetrahedra.len(), 4, "tetrahedra")?);
    if !frames.is_empty() {
        expect_length(frames.len(), 4 * cells, "frames")?;
    }
    let (mut out, mut report) = (std::ptr::null_mut(), Report::default());
    call(host, |host, error| unsafe {
        obc_hexmesh_compute_solid(pointer(positions), vertices, pointer(tetrahedra), cells, pointer(frames),
                                  &options.0, host, &mut report.0, &mut out, error)
    })?;
    Ok((Hexes::taken(HexesHandle::own(out))?, report))
}
