//! A surface without one of its faces.

use orbicube::mesh::Surface;
use orbicube::repair::{repair, surface_of_label, LabelOptions, Options};
use orbicube::sys::repair::OBC_REPAIR_FILLED_HOLE;
use orbicube::Host;

#[test]
fn a_hole_is_filled_and_reported() {
    let positions = [1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0];
    let triangles = [2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];
    let surface = Surface::new(&positions, &triangles).unwrap();
    let repaired = repair(surface, &Options::default(), &mut Host::new()).unwrap();
    assert_eq!(repaired.positions, positions);
    assert_eq!(repaired.triangles[..21], triangles);
    assert_eq!(repaired.triangle_source[7], u32::MAX);
    assert_eq!(repaired.events.len(), 1);
    assert_eq!(repaired.events[0].action, OBC_REPAIR_FILLED_HOLE as i32);
    assert_eq!((repaired.report.closed, repaired.report.manifold, repaired.report.genus), (1, 1, 0));
    let mut options = Options::default();
    options.fill_holes = 0;
    let surface = Surface::new(&positions, &triangles).unwrap();
    assert_eq!(repair(surface, &options, &mut Host::new()).unwrap().report.boundary_loops, 1);
    options.weld_distance = f64::NAN;
    let surface = Surface::new(&positions, &triangles).unwrap();
    assert!(repair(surface, &options, &mut Host::new()).is_err());
}

#[test]
fn a_label_has_a_closed_surface() {
    let mut labels = vec![0i32; 5 * 6 * 7];
    for (i, label) in labels.iter_mut().enumerate() {
        let (x, y, z) = (i % 5, i / 5 % 6, i / 30);
        *label = ((1..4).contains(&x) && (1..5).contains(&y) && (1..6).contains(&z) && (x, y) != (2, 2)) as i32 * 8;
    }
    let matrix = [2.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let made = surface_of_label(&labels, [5, 6, 7], Some(&matrix), &LabelOptions::default(), &mut Host::new()).unwrap();
    assert_eq!((made.report.closed, made.report.genus, made.label_report.label, made.label_report.handles), (1, 0, 8, 1));
    assert!(made.positions.iter().step_by(3).all(|x| (1.0..9.1).contains(x)));
    let mut options = LabelOptions::default();
    options.label = 7;
    assert!(surface_of_label(&labels, [5, 6, 7], None, &options, &mut Host::new()).is_err());
}
