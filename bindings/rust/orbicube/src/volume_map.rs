//! Maps of tetrahedral meshes without inverted tetrahedra, and meshes of hexahedra.
//!
//! ```
//! use orbicube::{mesh::Mesh, volume_map, Host};
//! let cube = Mesh::make("cube", 300, 0, &mut Host::new())?;
//! let mut options = volume_map::HexesOptions::default();
//! options.cells = 27;
//! let (hexes, report) = volume_map::fill_with_hexahedra(cube.surface(), &options, &mut Host::new())?;
//! assert!(hexes.hexahedra.len() >= 27 && report.min_scaled_jacobian > 0.0);
//! # Ok::<(), orbicube::Error>(())
//! ```

use crate::call::{call, checked, expect_length, pointer, rows, Error, Host};
use crate::mesh::Surface;
use crate::sys::base::OBC_NO_VALID_RESULT;
use crate::sys::volume_map::*;

filled!(/// Options, with their defaults.
    UntangleOptions, obc_volume_map_untangle_options, obc_volume_map_untangle_options_init);
filled!(/// Figures of a run.
    UntangleReport, obc_volume_map_untangle_report, obc_volume_map_untangle_report_init);

/// A mesh to untangle; empty: none.
#[derive(Clone, Copy, Debug, Default)]
pub struct UntangleProblem<'a> {
    pub positions: &'a [f64],
    pub tetrahedra: &'a [u32],
    /// Positions where each tetrahedron has the shape that it should have.
    pub rest: &'a [f64],
    /// One a coordinate, not 0 where it stays.
    pub fixed: &'a [u8],
    /// One a coordinate: its group, or `u32::MAX`.
    pub ties: &'a [u32],
}

/// Moves vertices until every tetrahedron is positive.
pub fn untangle(problem: &UntangleProblem, options: &UntangleOptions, host: &mut Host) -> Result<(Vec<f64>, UntangleReport), Error> {
    let (result, report, outcome) = best_of(problem, options, host)?;
    outcome.map(|_| (result, report))
}

/// The same; where some stay inverted, the best that was found, and the error beside it.
pub fn untangle_best(problem: &UntangleProblem, options: &UntangleOptions,
                     host: &mut Host) -> Result<(Vec<f64>, UntangleReport, Option<Error>), Error> {
    match best_of(problem, options, host)? {
        (result, report, Ok(())) => Ok((result, report, None)),
        (result, report, Err(error)) if error.status == OBC_NO_VALID_RESULT => Ok((result, report, Some(error))),
        (_, _, Err(error)) => Err(error),
    }
}

type Best = (Vec<f64>, UntangleReport, Result<(), Error>);

fn best_of(problem: &UntangleProblem, options: &UntangleOptions, host: &mut Host) -> Result<Best, Error> {
    let n = problem.positions.len();
    let mut c: obc_volume_map_untangle_problem = unsafe { std::mem::zeroed() };
    unsafe { obc_volume_map_untangle_problem_init(&mut c, std::mem::size_of::<obc_volume_map_untangle_problem>()) };
    c.positions = pointer(problem.positions);
    c.vertex_count = rows(n, 3, "positions")?;
    c.tetrahedra = pointer(problem.tetrahedra);
    c.tetrahedron_count = rows(problem.tetrahedra.len(), 4, "tetrahedra")?;
    for (length, what) in [(problem.rest.len(), "rest"), (problem.fixed.len(), "fixed"), (problem.ties.len(), "ties")] {
        if length != 0 {
            expect_length(length, n, what)?;
        }
    }
    c.rest = pointer(problem.rest);
    c.fixed = pointer(problem.fixed);
    c.ties = pointer(problem.ties);
    let (mut result, mut report) = (vec![0.0; n], UntangleReport::default());
    let outcome = call(host, |host, error| unsafe {
        obc_volume_map_untangle(&c, &options.0, host, result.as_mut_ptr(), &mut report.0, error)
    });
    Ok((result, report, outcome))
}

filled!(/// Options of the map to a polycube, with their defaults.
    SolidOptions, obc_volume_map_solid_options, obc_volume_map_solid_options_init);
filled!(/// Options of hexahedra, with their defaults.
    HexesOptions, obc_volume_map_hexes_options, obc_volume_map_hexes_options_init);
filled!(/// Options of hexahedra along frames, with their defaults.
    FrameOptions, obc_volume_map_frame_options, obc_volume_map_frame_options_init);
sized!(/// What was made of hexahedra.
    HexesReport, obc_volume_map_hexes_report);
sized!(/// What was made of hexahedra along frames.
    FrameReport, obc_volume_map_frame_report);

/// A solid, and the same on the polycube of its boundary.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Solid {
    pub positions: Vec<f64>,
    pub polycube: Vec<f64>,
    /// Of both: four vertices each, positive here and there.
    pub tetrahedra: Vec<u32>,
}

handle!(SolidHandle, obc_volume_map_solid, obc_volume_map_solid_destroy);
handle!(HexesHandle, obc_volume_map_hexes, obc_volume_map_hexes_destroy);

/// Maps positive tetrahedra one to one to a polycube, splitting them where that is needed.
pub fn map_to_polycube(positions: &[f64], tetrahedra: &[u32], options: &SolidOptions, host: &mut Host) -> Result<Solid, Error> {
    let (vertices, cells) = (rows(positions.len(), 3, "positions")?, rows(tetrahedra.len(), 4, "tetrahedra")?);
    let mut out = std::ptr::null_mut();
    call(host, |host, error| unsafe {
        obc_volume_map_solid_compute(pointer(positions), vertices, pointer(tetrahedra), cells, &options.0, host, &mut out, error)
    })?;
    let handle = SolidHandle::own(out);
    let out = handle.as_ptr();
    let mut solid = Solid::default();
    unsafe {
        solid.positions.resize(3 * obc_volume_map_solid_vertex_count(out), 0.0);
        solid.polycube.resize(solid.positions.len(), 0.0);
        solid.tetrahedra.resize(4 * obc_volume_map_solid_tetrahedron_count(out), 0);
        checked(|error| {
            obc_volume_map_solid_copy(out, solid.positions.as_mut_ptr(), solid.polycube.as_mut_ptr(),
                                      solid.tetrahedra.as_mut_ptr(), error)
        })?;
    }
    Ok(solid)
}

/// A certified mesh of hexahedra.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Hexes {
    pub positions: Vec<f64>,
    /// As MEDIT and VTK order their vertices.
    pub hexahedra: Vec<[u32; 8]>,
    /// Of the boundary, counter-clockwise seen from outside.
    pub quads: Vec<[u32; 4]>,
    /// Of the polycube, or of the map along frames: what each quad lies on.
    pub quad_patches: Vec<u32>,
}

impl Hexes {
    fn taken(handle: HexesHandle) -> Result<Hexes, Error> {
        let out = handle.as_ptr();
        let mut hexes = Hexes::default();
        unsafe {
            hexes.positions.resize(3 * obc_volume_map_hexes_vertex_count(out), 0.0);
            hexes.hexahedra.resize(obc_volume_map_hexes_count(out), [0; 8]);
            hexes.quads.resize(obc_volume_map_hexes_quad_count(out), [0; 4]);
            hexes.quad_patches.resize(hexes.quads.len(), 0);
            checked(|error| {
                obc_volume_map_hexes_copy(out, hexes.positions.as_mut_ptr(), hexes.hexahedra.as_mut_ptr() as *mut u32,
                                          hexes.quads.as_mut_ptr() as *mut u32, hexes.quad_patches.as_mut_ptr(), error)
            })?;
        }
        Ok(hexes)
    }
}

/// Fills a closed surface with hexahedra.
pub fn fill_with_hexahedra(surface: Surface, options: &HexesOptions, host: &mut Host) -> Result<(Hexes, HexesReport), Error> {
    let (mut out, mut report) = (std::ptr::null_mut(), HexesReport::default());
    call(host, |host, error| unsafe {
        obc_volume_map_hexes_compute(&surface.c, &options.0, host, &mut report.0, &mut out, error)
    })?;
    Ok((Hexes::taken(HexesHandle::own(out))?, report))
}

/// Fills a solid of tetrahedra with hexahedra that follow frames, w x y z a tetrahedron; empty: a smooth field is made, and
/// repaired.
pub fn fill_along_frames(positions: &[f64], tetrahedra: &[u32], frames: &[f64], options: &FrameOptions,
                         host: &mut Host) -> Result<(Hexes, FrameReport), Error> {
    let (vertices, cells) = (rows(positions.len(), 3, "positions")?, rows(tetrahedra.len(), 4, "tetrahedra")?);
    if !frames.is_empty() {
        expect_length(frames.len(), 4 * cells, "frames")?;
    }
    let (mut out, mut report) = (std::ptr::null_mut(), FrameReport::default());
    call(host, |host, error| unsafe {
        obc_volume_map_frame_hexes_compute(pointer(positions), vertices, pointer(tetrahedra), cells, pointer(frames),
                                           &options.0, host, &mut report.0, &mut out, error)
    })?;
    Ok((Hexes::taken(HexesHandle::own(out))?, report))
}
