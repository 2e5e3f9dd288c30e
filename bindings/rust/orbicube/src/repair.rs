//! Any triangles to a closed, oriented, manifold surface, with a certificate of what was reached.

use crate::call::{call, checked, Error, Host};
use crate::mesh::Surface;
use crate::sys::repair::*;

filled!(/// Options, with their defaults.
    Options, obc_repair_options, obc_repair_options_init);
filled!(/// Figures of the steps, and the certificate.
    Report, obc_repair_report, obc_repair_report_init);

/// What was done at one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// `OBC_REPAIR_...`
    pub action: i32,
    pub count: u32,
    pub place: [f64; 3],
    pub size: f64,
}

/// The surface, the numbers of its vertices and triangles in the input (`u32::MAX`: made by the repair), what was done and the report.
pub struct Repaired {
    pub positions: Vec<f64>,
    pub triangles: Vec<u32>,
    pub vertex_source: Vec<u32>,
    pub triangle_source: Vec<u32>,
    pub events: Vec<Event>,
    pub report: Report,
}

handle!(Handle, obc_repair, obc_repair_destroy);

/// Whether a closed, oriented manifold was reached is in the report.
pub fn repair(surface: Surface, options: &Options, host: &mut Host) -> Result<Repaired, Error> {
    let mut out = std::ptr::null_mut();
    call(host, |host, error| unsafe { obc_repair_compute(&surface.c, &options.0, host, &mut out, error) })?;
    let handle = Handle::own(out);
    let out = handle.as_ptr();
    unsafe {
        let (vertices, triangles, events) = (obc_repair_vertex_count(out), obc_repair_triangle_count(out), obc_repair_event_count(out));
        let mut result = Repaired {
            positions: vec![0.0; 3 * vertices],
            triangles: vec![0; 3 * triangles],
            vertex_source: vec![0; vertices],
            triangle_source: vec![0; triangles],
            events: Vec::with_capacity(events),
            report: Report::default(),
        };
        checked(|error| {
            obc_repair_copy(out, result.positions.as_mut_ptr(), result.triangles.as_mut_ptr(), result.vertex_source.as_mut_ptr(),
                            result.triangle_source.as_mut_ptr(), error)
        })?;
        let (mut actions, mut counts) = (vec![0; events], vec![0; events]);
        let (mut places, mut sizes) = (vec![0.0; 3 * events], vec![0.0; events]);
        checked(|error| {
            obc_repair_copy_events(out, actions.as_mut_ptr(), counts.as_mut_ptr(), places.as_mut_ptr(), sizes.as_mut_ptr(), error)
        })?;
        for i in 0..events {
            result.events.push(Event {
                action: actions[i],
                count: counts[i],
                place: [places[3 * i], places[3 * i + 1], places[3 * i + 2]],
                size: sizes[i],
            });
        }
        checked(|error| obc_repair_get_report(out, &mut result.report.0, error))?;
        Ok(result)
    }
}

filled!(/// Options of the surface of a label, with their defaults.
    LabelOptions, obc_repair_label_options, obc_repair_label_options_init);
filled!(/// Figures of the surface of a label.
    LabelReport, obc_repair_label_report, obc_repair_label_report_init);

/// The surface of a label, what was done, and the report with the certificate.
pub struct LabelSurface {
    pub positions: Vec<f64>,
    pub triangles: Vec<u32>,
    pub label_report: LabelReport,
    pub report: Report,
}

/// Extracts the closed surface of a label of an image: labels with x fastest, and the 4x4 matrix, row-major, from voxel numbers to
/// positions; `None`: positions are voxel numbers. Panics unless the number of labels is the product of the sizes.
pub fn surface_of_label(labels: &[i32], size: [usize; 3], to_world: Option<&[f64; 16]>, options: &LabelOptions, host: &mut Host)
                        -> Result<LabelSurface, Error> {
    let count = size[0].checked_mul(size[1]).and_then(|n| n.checked_mul(size[2]));
    assert_eq!(count, Some(labels.len()), "the number of labels is not the product of the sizes");
    let matrix = to_world.map_or(std::ptr::null(), |m| m.as_ptr());
    let mut out = std::ptr::null_mut();
    call(host, |host, error| unsafe {
        obc_repair_surface_of_label(labels.as_ptr(), size.as_ptr(), matrix, &options.0, host, &mut out, error)
    })?;
    let handle = Handle::own(out);
    let out = handle.as_ptr();
    unsafe {
        let mut result = LabelSurface {
            positions: vec![0.0; 3 * obc_repair_vertex_count(out)],
            triangles: vec![0; 3 * obc_repair_triangle_count(out)],
            label_report: LabelReport::default(),
            report: Report::default(),
        };
        let none = std::ptr::null_mut();
        checked(|error| obc_repair_copy(out, result.positions.as_mut_ptr(), result.triangles.as_mut_ptr(), none, none, error))?;
        checked(|error| obc_repair_get_report(out, &mut result.report.0, error))?;
        checked(|error| obc_repair_get_label_report(out, &mut result.label_report.0, error))?;
        Ok(result)
    }
}
