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

#[test]
fn all_that_is_known_of_a_polycube() {
    use orbicube::polycube::{Curve, Features, Place};
    let cube = Mesh::make("cube", 600, 0, &mut host()).unwrap();
    let map = Polycube::compute(cube.surface(), &Default::default(), &mut host()).unwrap();
    assert!(map.construction().is_some());
    let (positions, polycube, triangles) = map.arrays();
    let at = |v: u32| [polycube[3 * v as usize], polycube[3 * v as usize + 1], polycube[3 * v as usize + 2]];

    let graph = map.graph(&mut host()).unwrap();
    assert_eq!((graph.corner_vertices.len(), graph.edge_corners.len(), graph.patch_labels.len()), (8, 12, 6));
    assert!(graph.edge_convex.iter().all(|&convex| convex));
    for (vertex, position) in graph.corner_vertices.iter().zip(&graph.corner_positions) {
        assert_eq!(at(*vertex), *position);
    }
    let mut darts: Vec<u32> = graph.patch_loops.iter().flatten().flatten().copied().collect();
    darts.sort_unstable();
    assert_eq!(darts, (0..24).collect::<Vec<u32>>());
    assert!(graph.neighbours.iter().all(|neighbours| neighbours.len() == 4));

    let sources = map.sources().unwrap();
    for (i, (corners, weights)) in sources.corners.iter().zip(&sources.weights).enumerate() {
        for k in 0..3 {
            let sum: f64 = (0..3).filter(|&j| corners[j] != u32::MAX).map(|j| weights[j] * cube.positions()[3 * corners[j] as usize + k]).sum();
            assert!((sum - positions[3 * i + k]).abs() < 1e-12); // a cube of size one, weights with the sum one
        }
    }
    let quads = map.quads(&Default::default(), &mut host()).unwrap();
    for (i, (&triangle, weights)) in quads.triangles.iter().zip(&quads.weights).enumerate() {
        let corners = &triangles[3 * triangle as usize..3 * triangle as usize + 3];
        for k in 0..3 {
            let sum: f64 = (0..3).map(|j| weights[j] * polycube[3 * corners[j] as usize + k]).sum();
            assert!((sum - quads.polycube[3 * i + k]).abs() < 1e-12);
        }
    }

    // A vertex to another place of its patch, the others around it following.
    let kinds = map.of_triangles().unwrap();
    let inner = (0..map.vertex_count() as u32).find(|&v| {
        let around: Vec<u32> = (0..kinds.patches.len()).filter(|&t| triangles[3 * t..3 * t + 3].contains(&v)).map(|t| kinds.patches[t]).collect();
        around.iter().all(|&patch| patch == around[0])
    }).unwrap();
    let triangle = (0..kinds.patches.len()).find(|&t| triangles[3 * t..3 * t + 3].contains(&inner)).unwrap();
    let mut place = [0.0; 3];
    for &v in &triangles[3 * triangle..3 * triangle + 3] {
        for k in 0..3 {
            place[k] += at(v)[k] / 3.0;
        }
    }
    place[kinds.labels[triangle] as usize / 2] = at(inner)[kinds.labels[triangle] as usize / 2]; // in the plane to the bit
    let features = Features { points: vec![(inner, place, 0.0)], ..Default::default() };
    let (met, report) = map.meet_features(&features, &mut host()).unwrap();
    assert!(report.distance < 1e-12 && report.distance_before > 1e-3);
    assert_eq!(met.corner_count(), 8);
    let there = met.arrays().1;
    assert!((0..3).all(|k| (there[3 * inner as usize + k] - place[k]).abs() < 1e-12));
    let away = Features { points: vec![(inner, [100.0; 3], 0.0)], ..Default::default() };
    assert_eq!(map.meet_features(&away, &mut host()).err().unwrap().status, sys::base::OBC_INVALID_ARGUMENT);
    // A curve of an edge of the polycube lies on it already.
    let ends = [graph.corner_positions[graph.edge_corners[0][0] as usize], graph.corner_positions[graph.edge_corners[0][1] as usize]];
    let axis = (0..3).find(|&k| ends[0][k] != ends[1][k]).unwrap();
    let mut along: Vec<u32> = (0..map.vertex_count() as u32).filter(|&v| (0..3).all(|k| k == axis || at(v)[k] == ends[0][k])).collect();
    along.sort_by(|&v, &w| ((at(v)[axis] - ends[0][axis]).abs()).partial_cmp(&(at(w)[axis] - ends[0][axis]).abs()).unwrap());
    assert!(along.len() > 2);
    let curve = Curve { vertices: along, line: ends, weight: 0.0 };
    let (_, report) = map.meet_features(&Features { curves: vec![curve], ..Default::default() }, &mut host()).unwrap();
    assert!(report.distance < 1e-12);

    // Given to another surface, with a corner where it was and another near a point.
    let box_ = Surface::new(&polycube, &triangles).unwrap();
    let places = [(graph.corner_vertices[0], Place::Vertex(graph.corner_vertices[0])),
                  (graph.corner_vertices[1], Place::Near([positions[3 * graph.corner_vertices[1] as usize],
                                                          positions[3 * graph.corner_vertices[1] as usize + 1],
                                                          positions[3 * graph.corner_vertices[1] as usize + 2]]))];
    let surface = Surface::new(&positions, &triangles).unwrap();
    let placed = Polycube::compute_on_places(surface, box_, &places, &mut host()).unwrap();
    assert_eq!((placed.corner_count(), placed.construction()), (8, None));
    assert_eq!(placed.graph(&mut host()).unwrap().corner_positions.len(), 8);
    let unknown = [(u32::MAX - 1, Place::Near([0.0; 3]))];
    assert!(Polycube::compute_on_places(surface, box_, &unknown, &mut host()).is_err());

    let (maps, made_for) = Polycube::compute_common(&[cube.surface(), cube.surface()], &Default::default(), &Default::default(), &mut host()).unwrap();
    assert!(made_for < 2);
    let better = Polycube::optimize_common_domain(&[&maps[0], &maps[1]], &Default::default(), &mut host()).unwrap();
    let energies = better[0].energies().unwrap();
    assert!(energies.windows(2).all(|pair| pair[1] <= pair[0]));
    assert!(Polycube::optimize_common_domain(&[], &Default::default(), &mut host()).is_err());
}

#[test]
fn what_stays_tangled_is_handed_out_with_the_error() {
    let positions = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0];
    let tangle = volume_map::Tangle { positions: &positions, tetrahedra: &[0, 1, 2, 3], fixed: &[1; 12], ..Default::default() };
    let (best, report, error) = volume_map::untangle_best(&tangle, &Default::default(), &mut host()).unwrap();
    assert_eq!((best, report.inverted), (positions.to_vec(), 1));
    assert_eq!(error.unwrap().status, sys::base::OBC_NO_VALID_RESULT);
    assert!(volume_map::untangle(&tangle, &Default::default(), &mut host()).is_err());
    let wrong = volume_map::Tangle { ties: &[7; 3], ..tangle };
    assert_eq!(volume_map::untangle_best(&wrong, &Default::default(), &mut host()).err().unwrap().status, sys::base::OBC_INVALID_ARGUMENT);
}

#[test]
fn pointers_that_safe_code_sets_are_not_followed() {
    unsafe extern "C" fn never(_: u64, _: u64, _: f64, _: *mut std::os::raw::c_void) {
        std::process::abort();
    }
    let shape = Mesh::make("sphere", 300, 0, &mut host()).unwrap();
    let mut options = sphere_map::Options::default();
    options.method = sys::sphere_map::OBC_SPHERE_MAP_SEED;
    options.trace = Some(never);
    options.trace_user = 1 as *mut _;
    let (directions, _) = sphere_map::compute(shape.surface(), &options, &mut host()).unwrap();
    sphere_map::measure(shape.surface(), &directions, &options, &mut host()).unwrap();

    let mut told = 0;
    let traced = sphere_map::compute_traced(shape.surface(), &options, |_, _, _| told += 1, &mut host()).unwrap();
    assert_eq!(traced.0, directions);
    assert!(told > 0);
    let panic = catch_unwind(AssertUnwindSafe(|| {
        let _ = sphere_map::compute_traced(shape.surface(), &options, |_, _, _| panic!("traced"), &mut host());
    }));
    assert_eq!(panic.unwrap_err().downcast_ref::<&str>(), Some(&"traced"));

    #[cfg(feature = "tetrahedra")]
    {
        use orbicube::tetrahedra::{fill, fill_sized, Options};
        let mut options = Options::default();
        options.size_positions = 8 as *const f64;
        options.size_lengths = 8 as *const f64;
        options.size_count = 1000;
        let plain = fill(shape.surface(), &options, &mut host()).unwrap();
        let fine = fill_sized(shape.surface(), &options, &[([0.0; 3], 0.05)], &mut host()).unwrap();
        assert!(fine.tetrahedra.len() > plain.tetrahedra.len());
    }
}

#[test]
fn sizes_beyond_all_memory_are_errors() {
    assert!(harmonics::Coefficients::new(u32::MAX, 3, vec![]).is_err());
    assert!(harmonics::Coefficients::new(u32::MAX, usize::MAX, vec![]).is_err());
    let mut options = harmonics::FitOptions::default();
    options.degree = u32::MAX;
    assert!(harmonics::fit(&[0.0, 0.0, 1.0], &[], &[1.0], 1, &options, &mut host()).is_err());
}
