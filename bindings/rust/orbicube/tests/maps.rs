//! Meshes, maps, harmonics, frames and polycubes: what comes out is what the libraries promise.

use std::panic::{catch_unwind, AssertUnwindSafe};

use orbicube::mesh::{self, Mesh, Surface};
use orbicube::{frame_field, gltf, harmonics, polycube::Polycube, quaternion, sphere_map, sys, volume_map, Host};

fn host() -> Host<'static> {
    Host::new()
}

#[test]
fn files_hold_the_same_bits_and_defects_are_named() {
    let shape = Mesh::make("creature", 1000, 3, &mut host()).unwrap();
    let folder = std::env::temp_dir().join(format!("orbicube-rust-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    shape.write(folder.join("a.ply"), &Default::default(), &mut host()).unwrap();
    let again = Mesh::read(folder.join("a.ply"), &Default::default(), &mut host()).unwrap();
    assert_eq!((again.positions(), again.triangles()), (shape.positions(), shape.triangles()));
    assert!(again.format().contains("PLY"));
    let error = Mesh::read(folder.join("none.ply"), &Default::default(), &mut host()).err().unwrap();
    assert_eq!(error.status, sys::base::OBC_IO);
    assert!(error.to_string().contains("none.ply"));
    std::fs::remove_dir_all(&folder).unwrap();

    let open = Surface::new(shape.positions(), &shape.triangles()[3..]).unwrap();
    let error = mesh::check_closed_genus_zero(open, &mut host()).unwrap_err();
    assert_eq!((error.status, error.kind.as_str()), (sys::base::OBC_NOT_CLOSED, "not-closed"));
    assert!(Surface::new(&[0.0; 4], &[]).is_err());
    assert!(Mesh::make("nothing of the kind", 100, 0, &mut host()).is_err());
    assert!(mesh::shape_names().contains(&"torus".to_string()));
    assert_eq!(mesh::orientation_from_origin([0.1; 3], [0.2; 3], [0.0, 0.0, 1.0]), Some(0));
    assert_eq!(mesh::orientation_2d([f64::NAN, 0.0], [1.0, 0.0], [0.0, 1.0]), None);
    let search = mesh::Search::new(shape.surface(), &mut host()).unwrap();
    let first = [shape.positions()[0], shape.positions()[1], shape.positions()[2]];
    assert_eq!(search.vertices(&[first]).unwrap(), [0]);
    assert_eq!(search.surface(&[first]).unwrap()[0].distance, 0.0);
}

#[test]
fn a_map_of_a_creature() {
    let shape = Mesh::make("creature", 400, 0, &mut host()).unwrap();
    let mut reports = 0;
    let (directions, report) = sphere_map::compute(shape.surface(), &Default::default(), &mut Host::new().threads(1).on_progress(|_| {
        reports += 1;
        true
    })).unwrap();
    assert!(report.bijective == 1 && reports > 3);
    assert_eq!(sphere_map::compute(shape.surface(), &Default::default(), &mut Host::new().threads(3)).unwrap().0, directions);
    let cancelled = sphere_map::compute(shape.surface(), &Default::default(), &mut Host::new().on_progress(|_| false));
    assert!(cancelled.err().unwrap().is_cancelled());
    let panic = catch_unwind(AssertUnwindSafe(|| {
        let _ = sphere_map::compute(shape.surface(), &Default::default(), &mut Host::new().on_progress(|_| panic!("here")));
    }));
    assert_eq!(panic.unwrap_err().downcast_ref::<&str>(), Some(&"here"));

    let locator = sphere_map::Locator::new(shape.surface(), &directions, &mut host()).unwrap();
    let at: Vec<[f64; 3]> = directions.chunks(3).map(|d| [d[0], d[1], d[2]]).collect();
    let sampled = locator.sample(&at, shape.positions(), false, &mut host()).unwrap();
    assert!(sampled.iter().zip(shape.positions()).all(|(a, b)| (a - b).abs() < 1e-12)); // weights of 1 but for rounding
    let (locator, at) = (&locator, &at);
    std::thread::scope(|scope| {
        for _ in 0..3 {
            scope.spawn(move || assert_eq!(locator.locate(at, &mut Host::new().threads(1)).unwrap().len(), at.len()));
        }
    });
    let regular = locator.remesh(shape.positions(), sys::sphere_map::OBC_SPHERE_MAP_ICOSPHERE, 3, &mut host()).unwrap();
    assert_eq!(regular.positions().len(), 3 * 642);

    let areas = harmonics::vertex_areas(shape.positions(), shape.triangles(), &mut host()).unwrap();
    let mut options = harmonics::FitOptions::default();
    options.degree = 5;
    let (a, fit) = harmonics::fit(&directions, &areas, shape.positions(), 3, &options, &mut host()).unwrap();
    assert_eq!(fit.rank, 36);
    let turn = quaternion::to_matrix(quaternion::normalize([1.0, 2.0, 3.0, 4.0]));
    let turned = a.rotate(&turn, &mut host()).unwrap();
    assert!(harmonics::shape_distance(&a, &turned, 0, 5).unwrap() < 1e-20);
    let found = harmonics::align(&turned, &a, &Default::default(), &mut host()).unwrap();
    assert!(found.rotation.iter().zip(turn).all(|(a, b)| (a - b).abs() < 1e-7));

    let path = std::env::temp_dir().join(format!("orbicube-rust-{}.glb", std::process::id()));
    let positions: Vec<f32> = shape.positions().iter().map(|&x| x as f32).collect();
    let sphere = sphere_map::round_to_float(shape.surface(), &directions, &mut host()).unwrap();
    let scene = gltf::Scene { positions: &positions, triangles: shape.triangles(), morph_targets: &[("sphere", &sphere)],
                              smooth_normals: true, ..Default::default() };
    gltf::write(&path, &scene, &mut host()).unwrap();
    let read = gltf::read(&path, Some("sphere"), &Default::default(), &mut host()).unwrap();
    assert!(read.positions.chunks(3).all(|p| (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 1.0).abs() < 1e-5)); // float32
    std::fs::remove_file(&path).unwrap();
}

#[test]
fn quaternions_frames_and_polycubes() {
    use quaternion::*;
    let q = normalize([1.0, -2.0, 0.5, 3.0]);
    for g in 0..24 {
        let element = cube_element(g).unwrap();
        assert_eq!(cube_nearest(element), g);
        assert!(symmetric_distance(q, multiply(q, element)) < 1e-14);
    }
    assert!(cube_element(24).is_err() && cube_product(0, 24).is_none());
    assert!((average(&[q, q], &[]).unwrap().1 - 1.0).abs() < 1e-14);
    assert!(from_matrix(&[2.0; 9]).is_err());

    let corners = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0];
    let solid = frame_field::Solid::new(&corners, &[0, 1, 2, 3]).unwrap();
    let held = frame_field::Constraints { frames: vec![(0, q)], ..Default::default() };
    let mut options = frame_field::Options::default();
    options.align_boundary = 0;
    let (frames, _) = frame_field::compute(solid, &options, &held, &[], &mut host()).unwrap();
    assert!(symmetric_distance([frames[0], frames[1], frames[2], frames[3]], q) < 1e-14);
    assert!(frame_field::singularities(solid, &frames, &mut host()).unwrap().edges.is_empty());

    // Four tetrahedra around a vertex that has left the one that they fill.
    let mut positions = corners.to_vec();
    positions.extend([2.0, 2.0, 2.0]);
    let tetrahedra = [0, 1, 2, 4, 0, 2, 3, 4, 0, 3, 1, 4, 1, 3, 2, 4];
    let mut fixed = vec![1; 12];
    fixed.extend([0; 3]);
    let tangle = volume_map::Tangle { positions: &positions, tetrahedra: &tetrahedra, fixed: &fixed, ..Default::default() };
    let (untangled, report) = volume_map::untangle(&tangle, &Default::default(), &mut host()).unwrap();
    assert!(report.inverted_before > 0 && report.inverted == 0);
    assert_eq!(untangled[..12], corners);
    assert!(untangled[12..].iter().all(|&x| x > 0.0) && untangled[12..].iter().sum::<f64>() < 1.0);

    let cube = Mesh::make("cube", 300, 0, &mut host()).unwrap();
    let map = Polycube::compute(cube.surface(), &Default::default(), &mut host()).unwrap();
    let (better, report) = map.optimize_domain(&Default::default(), &mut host()).unwrap();
    assert!(report.energy <= report.energy_before);
    assert_eq!((better.corner_count(), better.patch_count()), (8, 6));
    let (positions, polycube, triangles) = better.arrays();
    assert_eq!(&positions[..cube.positions().len()], cube.positions());
    let surface = Surface::new(&positions, &triangles).unwrap();
    assert!(Polycube::certify(surface, &polycube, &mut host()).is_ok());
    let error = Polycube::certify(surface, &vec![0.0; polycube.len()], &mut host()).err().unwrap();
    assert_eq!(error.status, sys::base::OBC_NO_VALID_RESULT);
    assert!(better.quads(&Default::default(), &mut host()).unwrap().corners.len() > 5000);
    assert_eq!(better.of_triangles().unwrap().labels.len(), better.triangle_count());
}
