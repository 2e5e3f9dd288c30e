//! Smooth octahedral frame fields on tetrahedral meshes, and their singular curves.

use crate::call::{call, checked, expect_length, pointer, rows, Error, Host};
use crate::sys::frame_field::*;

filled!(/// Options, with their defaults.
    Options, obc_frame_field_options, obc_frame_field_options_init);
filled!(/// Figures of a field.
    Report, obc_frame_field_report, obc_frame_field_report_init);

/// Tetrahedra that lie elsewhere.
#[derive(Clone, Copy)]
pub struct Solid<'a> {
    positions: &'a [f64],
    tetrahedra: &'a [u32],
}

impl<'a> Solid<'a> {
    pub fn new(positions: &'a [f64], tetrahedra: &'a [u32]) -> Result<Solid<'a>, Error> {
        rows(positions.len(), 3, "positions")?;
        rows(tetrahedra.len(), 4, "tetrahedra")?;
        Ok(Solid { positions, tetrahedra })
    }
    fn c(&self) -> obc_frame_field_solid {
        obc_frame_field_solid {
            positions: pointer(self.positions),
            vertex_count: self.positions.len() / 3,
            tetrahedra: pointer(self.tetrahedra),
            tetrahedron_count: self.tetrahedra.len() / 4,
        }
    }
}

/// What is fixed: frames (w x y z) and axes (x y z) of some tetrahedra.
#[derive(Clone, Debug, Default)]
pub struct Constraints {
    pub frames: Vec<(u32, [f64; 4])>,
    pub axes: Vec<(u32, [f64; 3])>,
}

/// Frames, w x y z a tetrahedron, and their figures. `start`: frames for the start `OBC_FRAME_FIELD_GIVEN`, else empty.
pub fn compute(solid: Solid, options: &Options, held: &Constraints, start: &[f64], host: &mut Host) -> Result<(Vec<f64>, Report), Error> {
    let mut frames = vec![0.0; solid.tetrahedra.len()];
    if !start.is_empty() {
        expect_length(start.len(), frames.len(), "start")?;
        frames.copy_from_slice(start);
    }
    let mut c: obc_frame_field_constraints = unsafe { std::mem::zeroed() };
    unsafe { obc_frame_field_constraints_init(&mut c, std::mem::size_of::<obc_frame_field_constraints>()) };
    let (frame_cells, frame_values): (Vec<u32>, Vec<[f64; 4]>) = held.frames.iter().copied().unzip();
    let (axis_cells, axis_values): (Vec<u32>, Vec<[f64; 3]>) = held.axes.iter().copied().unzip();
    c.frame_tetrahedra = pointer(&frame_cells);
    c.frames = pointer(&frame_values) as *const f64;
    c.frame_count = frame_cells.len();
    c.axis_tetrahedra = pointer(&axis_cells);
    c.axes = pointer(&axis_values) as *const f64;
    c.axis_count = axis_cells.len();
    let mut report = Report::default();
    call(host, |host, error| unsafe {
        obc_frame_field_compute(&solid.c(), &options.0, &c, host, frames.as_mut_ptr(), &mut report.0, error)
    })?;
    Ok((frames, report))
}

/// Figures of any field.
pub fn measure(solid: Solid, frames: &[f64], host: &mut Host) -> Result<Report, Error> {
    expect_length(frames.len(), solid.tetrahedra.len(), "frames")?;
    let mut report = Report::default();
    call(host, |host, error| unsafe { obc_frame_field_measure(&solid.c(), frames.as_ptr(), host, &mut report.0, error) })?;
    Ok(report)
}

/// Four rotations of the cube a tetrahedron, across the faces opposite to its corners.
pub fn matchings(solid: Solid, frames: &[f64], host: &mut Host) -> Result<Vec<u8>, Error> {
    expect_length(frames.len(), solid.tetrahedra.len(), "frames")?;
    let mut found = vec![0; frames.len()];
    call(host, |host, error| unsafe { obc_frame_field_matchings(&solid.c(), frames.as_ptr(), host, found.as_mut_ptr(), error) })?;
    Ok(found)
}

handle!(Handle, obc_frame_field_singularities, obc_frame_field_singularities_destroy);

/// Singular edges, and the curves that they form (numbers of edges, in order).
#[derive(Clone, Debug, Default)]
pub struct Singularities {
    pub edges: Vec<[u32; 2]>,
    pub rotations: Vec<u8>,
    pub turns: Vec<i8>,
    pub curves: Vec<Vec<u32>>,
    pub nodes: Vec<u32>,
    pub unmeshable_edges: Vec<u32>,
    pub unmeshable_vertices: Vec<u32>,
}

pub fn singularities(solid: Solid, frames: &[f64], host: &mut Host) -> Result<Singularities, Error> {
    expect_length(frames.len(), solid.tetrahedra.len(), "frames")?;
    let mut out = std::ptr::null_mut();
    call(host, |host, error| unsafe {
        obc_frame_field_singularities_create(&solid.c(), frames.as_ptr(), host, &mut out, error)
    })?;
    let handle = Handle::own(out);
    let out = handle.as_ptr();
    let n = unsafe { obc_frame_field_singular_edge_count(out) };
    let mut found = Singularities { edges: vec![[0; 2]; n], rotations: vec![0; n], turns: vec![0; n], ..Singularities::default() };
    let mut begin = vec![0; unsafe { obc_frame_field_singular_curve_count(out) } + 1];
    let mut along = vec![0; n];
    found.nodes.resize(unsafe { obc_frame_field_singular_node_count(out) }, 0);
    found.unmeshable_edges.resize(unsafe { obc_frame_field_unmeshable_edge_count(out) }, 0);
    found.unmeshable_vertices.resize(unsafe { obc_frame_field_unmeshable_vertex_count(out) }, 0);
    checked(|error| unsafe {
        obc_frame_field_singularities_copy(out, found.edges.as_mut_ptr() as *mut u32, found.rotations.as_mut_ptr(),
                                           found.turns.as_mut_ptr(), begin.as_mut_ptr(), along.as_mut_ptr(),
                                           found.nodes.as_mut_ptr(), error)
    })?;
    checked(|error| unsafe {
        obc_frame_field_unmeshable_copy(out, found.unmeshable_edges.as_mut_ptr(), found.unmeshable_vertices.as_mut_ptr(), error)
    })?;
    found.curves = begin.windows(2).map(|ends| along[ends[0]..ends[1]].to_vec()).collect();
    Ok(found)
}
