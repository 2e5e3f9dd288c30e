//! Meshes, maps, harmonics, frames and polycubes: what comes out is what the libraries promise.

use std::panic::{catch_unwind, AssertUnwindSafe};

use orbicube::mesh::{self, Mesh, Surface};
use orbicube::{frame_field, gltf, harmonics, hexmesh, polycube::Polycube, quaternion, sphere_map, sys, untangle, volume_map, Host};

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
    let cells: Vec<String> = mesh::formats().into_iter().filter(|format| format.cells).map(|format| format.ending).collect();
    assert_eq!(cells, [".mesh", ".vtk", ".msh", ".inp", ".vtu"]);
    let marked = Mesh::new(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0], &[0, 1, 2, 0, 2, 1], &[], &[]).unwrap();
    assert!(marked.triangle_regions().is_empty());
    let marked = marked.with_regions(&[7, -2], &[], &[]).unwrap();
    assert_eq!((marked.triangle_regions(), marked.tetrahedron_regions()), (vec![7, -2], vec![]));
    assert!(marked.with_regions(&[7], &[], &[]).is_err());
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

    let areas = mesh::vertex_areas(shape.surface(), &mut host()).unwrap();
    let mut options = harmonics::FitOptions::default();
    options.degree = 5;
    let (a, fit) = harmonics::fit(&directions, &areas, shape.positions(), 3, &options, &mut host()).unwrap();
    assert_eq!(fit.rank, 36);
    let (moved, refinement) =
        harmonics::refine_map(shape.positions(), shape.triangles(), &directions, &areas, &options, 3, &mut host()).unwrap();
    assert!(moved.len() == directions.len() && refinement.residual < refinement.residual_before);
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
    let keeping = gltf::ReadOptions(sys::gltf::obc_gltf_read_options { keep: 1, ..gltf::ReadOptions::default().0 });
    let surface = gltf::read(&path, None, &keeping, &mut host()).unwrap();
    let again = path.with_extension("kept.glb");
    gltf::write(&again, &gltf::Scene { positions: &positions, triangles: &surface.triangles, kept: surface.kept.as_deref(), ..Default::default() },
                &mut host()).unwrap();
    gltf::write_kept(&again, surface.kept.as_ref().unwrap(), &mut host()).unwrap();
    assert_eq!(gltf::read(&again, None, &Default::default(), &mut host()).unwrap().positions, surface.positions);
    let read = gltf::read(&path, Some("sphere"), &Default::default(), &mut host()).unwrap();
    assert!(read.positions.chunks(3).all(|p| (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 1.0).abs() < 1e-5)); // float32
    std::fs::remove_file(&again).unwrap();
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
    let problem = untangle::Tetrahedra { positions: &positions, tetrahedra: &tetrahedra, fixed: &[1, 1, 1, 1, 0], ..Default::default() };
    let (untangled, report) = untangle::tetrahedra(&problem, &Default::default(), &mut host()).unwrap();
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
    use orbicube::polycube::{AtlasOptions, Curve, Features, Place};
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
    assert!(graph.neighbors.iter().all(|neighbors| neighbors.len() == 4));

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

    let mut square = AtlasOptions::default();
    square.size = 64;
    let atlas = map.atlas(&square, &mut host()).unwrap();
    let (coordinates, texels) = (atlas.coordinates().unwrap(), atlas.sample(&mut host()).unwrap());
    let (scale, coverage) = atlas.scale_and_coverage().unwrap();
    assert!(atlas.size() == 64 && coordinates.len() == map.triangle_count() && scale > 0.0);
    let mut covered = 0.0;
    for (i, weights) in texels.weights.iter().enumerate().filter(|&(i, _)| texels.covered[i]) {
        let u: f64 = (0..3).map(|k| weights[k] * coordinates[texels.triangles[i] as usize][k][0]).sum();
        assert!((64.0 * u - (i % 64) as f64 - 0.5).abs() < 1e-9);
        covered += 1.0;
    }
    // Six rectangles have the middles that their areas say, up to one along each of their sides, which have up to 32 texels.
    assert!((covered - 64.0 * 64.0 * coverage).abs() < 6.0 * 2.0 * 32.0);

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
    let (met, report) = map.align_features(&features, &mut host()).unwrap();
    assert!(report.distance < 1e-12 && report.distance_before > 1e-3);
    assert_eq!(met.corner_count(), 8);
    let there = met.arrays().1;
    assert!((0..3).all(|k| (there[3 * inner as usize + k] - place[k]).abs() < 1e-12));
    let away = Features { points: vec![(inner, [100.0; 3], 0.0)], ..Default::default() };
    assert_eq!(map.align_features(&away, &mut host()).err().unwrap().status, sys::base::OBC_INVALID_ARGUMENT);
    // A curve of an edge of the polycube lies on it already.
    let ends = [graph.corner_positions[graph.edge_corners[0][0] as usize], graph.corner_positions[graph.edge_corners[0][1] as usize]];
    let axis = (0..3).find(|&k| ends[0][k] != ends[1][k]).unwrap();
    let mut along: Vec<u32> = (0..map.vertex_count() as u32).filter(|&v| (0..3).all(|k| k == axis || at(v)[k] == ends[0][k])).collect();
    along.sort_by(|&v, &w| ((at(v)[axis] - ends[0][axis]).abs()).partial_cmp(&(at(w)[axis] - ends[0][axis]).abs()).unwrap());
    assert!(along.len() > 2);
    let curve = Curve { vertices: along, line: ends, weight: 0.0 };
    let (_, report) = map.align_features(&Features { curves: vec![curve], ..Default::default() }, &mut host()).unwrap();
    assert!(report.distance < 1e-12);

    // Given to another surface, with a corner where it was and another near a point.
    let box_ = Surface::new(&polycube, &triangles).unwrap();
    let places = [(graph.corner_vertices[0], Place::Vertex(graph.corner_vertices[0])),
                  (graph.corner_vertices[1], Place::Near([positions[3 * graph.corner_vertices[1] as usize],
                                                          positions[3 * graph.corner_vertices[1] as usize + 1],
                                                          positions[3 * graph.corner_vertices[1] as usize + 2]]))];
    let surface = Surface::new(&positions, &triangles).unwrap();
    let placed = Polycube::map_to_domain_with_constraints(surface, box_, &places, &mut host()).unwrap();
    assert_eq!((placed.corner_count(), placed.construction()), (8, None));
    assert_eq!(placed.graph(&mut host()).unwrap().corner_positions.len(), 8);
    let unknown = [(u32::MAX - 1, Place::Near([0.0; 3]))];
    assert!(Polycube::map_to_domain_with_constraints(surface, box_, &unknown, &mut host()).is_err());

    let (maps, constructed_from) = Polycube::compute_common(&[cube.surface(), cube.surface()], &Default::default(), &Default::default(), &mut host()).unwrap();
    assert!(constructed_from < 2);
    let better = Polycube::optimize_common_domain(&[&maps[0], &maps[1]], &Default::default(), &mut host()).unwrap();
    let energies = better[0].energies().unwrap();
    assert!(energies.windows(2).all(|pair| pair[1] <= pair[0]));
    assert!(Polycube::optimize_common_domain(&[], &Default::default(), &mut host()).is_err());
}

#[test]
fn what_stays_tangled_is_handed_out_with_the_error() {
    let positions = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0];
    let problem = untangle::Tetrahedra { positions: &positions, tetrahedra: &[0, 1, 2, 3], fixed_coordinates: &[1; 12], ..Default::default() };
    let (best, report, error) = untangle::tetrahedra_best(&problem, &Default::default(), &mut host()).unwrap();
    assert_eq!((best, report.inverted), (positions.to_vec(), 1));
    assert_eq!(error.unwrap().status, sys::base::OBC_NO_VALID_RESULT);
    assert!(untangle::tetrahedra(&problem, &Default::default(), &mut host()).is_err());
    // Four triangles around a vertex that has left the square that they fill.
    let flat = [0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0, 3.0, 2.0];
    let triangles = untangle::Triangles { positions: &flat, triangles: &[0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4], ..Default::default() };
    let (untangled, report) = untangle::triangles(&triangles, &Default::default(), &mut host()).unwrap();
    assert!(report.inverted_before > 0 && report.inverted == 0 && (untangled[8] - 0.5).abs() < 0.01);
    assert!(untangle::triangles(&untangle::Triangles { rest: &[1.0; 10], ..triangles }, &Default::default(), &mut host()).is_err());
    let wrong = untangle::Tetrahedra { ties: &[7; 3], ..problem };
    assert_eq!(untangle::tetrahedra_best(&wrong, &Default::default(), &mut host()).err().unwrap().status, sys::base::OBC_INVALID_ARGUMENT);
}

#[test]
fn elements_without_room_are_split() {
    // Around an edge that passes outside of the triangle in the middle, and on both sides of a diagonal outside of a dart.
    let positions = [0.0, 0.0, -1.0, 3.0, 0.0, 1.0, 1.0, 0.0, 0.0, -0.5, 0.75, 0.0, -0.5, -0.75, 0.0];
    let problem = untangle::Tetrahedra { positions: &positions, tetrahedra: &[0, 1, 2, 3, 0, 1, 3, 4, 0, 1, 4, 2], ..Default::default() };
    let (solid, report) = untangle::refine_tetrahedra(&problem, &Default::default(), &mut host()).unwrap();
    assert_eq!((report.inverted_before, report.inverted), (2, 0));
    assert_eq!((solid.elements.len(), solid.parents.len(), &solid.positions[..15]), (24, 6, &positions[..]));
    assert_eq!((&solid.origins[20..], &solid.weights[20..]), (&[0, 1, u32::MAX, u32::MAX][..], &[0.5, 0.5, 0.0, 0.0][..]));
    let dart = [0.0, 0.0, 2.0, 1.0, 0.0, 4.0, 1.0, 1.0];
    let problem = untangle::Triangles { positions: &dart, triangles: &[0, 1, 2, 0, 2, 3], ..Default::default() };
    let (flat, report) = untangle::refine_triangles(&problem, &Default::default(), &mut host()).unwrap();
    assert_eq!((report.inverted, flat.positions.len(), flat.elements.len(), flat.origins.len()), (0, 10, 12, 15));
    let crossed = untangle::Triangles { positions: &[0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0], ..problem };
    assert_eq!(untangle::refine_triangles(&crossed, &Default::default(), &mut host()).err().unwrap().status, sys::base::OBC_NO_VALID_RESULT);
}

#[test]
fn what_maps_to_the_sphere_are_for() {
    use sys::sphere_map::OBC_SPHERE_MAP_OCTAHEDRON;
    let shape = Mesh::make("creature", 400, 0, &mut host()).unwrap();
    let (directions, _) = sphere_map::compute(shape.surface(), &Default::default(), &mut host()).unwrap();
    let (same, placed, error) = sphere_map::compute_partial(shape.surface(), &Default::default(), &mut host()).unwrap();
    assert!(same == directions && 3 * placed == directions.len() && error.is_none());
    let (_, _, error) = sphere_map::compute_partial(shape.surface(), &Default::default(), &mut Host::new().on_progress(|_| false)).unwrap();
    assert!(error.unwrap().is_cancelled());

    let folder = std::env::temp_dir().join(format!("orbicube-rust-images-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let locator = sphere_map::Locator::new(shape.surface(), &directions, &mut host()).unwrap();
    let image = sphere_map::Image::of(&locator, shape.positions(), OBC_SPHERE_MAP_OCTAHEDRON, 16, &mut host()).unwrap();
    assert_eq!(image.pixels().len(), 17 * 17);
    let (surface, gap) = image.surface(&mut host()).unwrap();
    assert_eq!((gap, mesh::topology(surface.surface(), &mut host()).unwrap().genus), (0.0, 0));
    image.write(folder.join("image.pfm"), &mut host()).unwrap();
    let again = sphere_map::Image::read(folder.join("image.pfm"), &mut host()).unwrap();
    assert_eq!((again.layout(), again.resolution()), (OBC_SPHERE_MAP_OCTAHEDRON, 16));
    assert!(again.pixels().iter().flatten().zip(image.pixels().iter().flatten()).all(|(a, b)| *a == f64::from(*b as f32)));
    assert!(sphere_map::Image::new(OBC_SPHERE_MAP_OCTAHEDRON, 16, vec![[0.0; 3]; 16]).is_err());

    let turned: Vec<f64> = directions.chunks(3).flat_map(|d| [-d[1], d[0], d[2]]).collect();
    let (sphere, found) = sphere_map::overlay(shape.surface(), &directions, shape.surface(), &turned, &mut host()).unwrap();
    assert_eq!(mesh::topology(sphere.surface(), &mut host()).unwrap().genus, 0);
    assert!(found.iter().all(|&v| (v as usize) < sphere.positions().len() / 3));

    let mut options = harmonics::FitOptions::default();
    options.degree = 6;
    let (a, _) = harmonics::fit(&directions, &[], shape.positions(), 3, &options, &mut host()).unwrap();
    let rows = harmonics::evaluate(&[0.0, 0.0, 1.0], a.degree(), &mut host()).unwrap();
    let pole = a.synthesize(&[0.0, 0.0, 1.0], &mut host()).unwrap();
    let sum: f64 = rows.iter().enumerate().map(|(k, y)| y * a.values()[3 * k]).sum();
    assert!((sum - pole[0]).abs() < 1e-12);
    let slopes = a.gradients(&[0.0, 0.0, 1.0], &mut host()).unwrap();
    let step = 1e-6; // the rounding of a difference is near 1e-10
    let near = a.synthesize(&[f64::sin(step), 0.0, f64::cos(step)], &mut host()).unwrap();
    assert!((0..3).all(|k| ((near[k] - pole[k]) / step - slopes[3 * k]).abs() < 1e-4));
    let points: Vec<[f64; 3]> = shape.positions().chunks(3).map(|p| [p[0], p[1], p[2]]).collect();
    assert_eq!(mesh::mean_distance(&points, &points, &mut host()).unwrap(), 0.0);

    let positions: Vec<f32> = shape.positions().iter().map(|&x| x as f32).collect();
    let colors = vec![[255, 0, 0, 255]; positions.len() / 3];
    let scene = gltf::Scene { positions: &positions, triangles: shape.triangles(), colors: &colors, edges: &[[0, 1]], scale: Some(2.0),
                              base_color: Some([1.0, 0.5, 0.0, 1.0]), extras: Some("{\"made\": 1}"), ..Default::default() };
    gltf::write(folder.join("shape.glb"), &scene, &mut host()).unwrap();
    let bytes = std::fs::read(folder.join("shape.glb")).unwrap();
    let read = gltf::read_memory(&bytes, None, None, &Default::default(), &mut host()).unwrap();
    assert_eq!(read.triangles, shape.triangles());
    assert!(read.positions.iter().zip(&positions).all(|(a, b)| *a == 2.0 * f64::from(*b)));
    assert!(gltf::read_memory(&bytes[1..], None, None, &Default::default(), &mut host()).is_err());
    assert!(gltf::write(folder.join("bad.glb"), &gltf::Scene { colors: &colors[1..], ..scene }, &mut host()).is_err());
    std::fs::remove_dir_all(&folder).unwrap();

    for g in 0..24 {
        assert_eq!(quaternion::cube_product(g, quaternion::cube_inverse(g).unwrap()), Some(0));
    }
    assert_eq!((quaternion::cube_inverse(24), quaternion::cube_class(24)), (None, None));
    assert_eq!(quaternion::cube_class(0), Some(sys::quaternion::OBC_QUATERNION_IDENTITY));
    let q = quaternion::from_axis_angle([0.0, 0.0, 1.0], 0.4).unwrap();
    assert!((quaternion::symmetric_sine_square([1.0, 0.0, 0.0, 0.0], q) - f64::sin(0.2).powi(2)).abs() < 1e-15);
}

/// Eight corners, and six tetrahedra around the diagonal.
fn cube_of_tetrahedra() -> (Vec<f64>, Vec<u32>) {
    let corners = (0..8).flat_map(|i| [f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)]).collect();
    let ring = [1, 3, 2, 6, 4, 5];
    (corners, (0..6).flat_map(|i| [0, ring[i], ring[(i + 1) % 6], 7]).collect())
}

/// The minimum scaled Jacobian, by arithmetic of our own.
fn min_scaled_jacobian(hexes: &hexmesh::Hexes) -> f64 {
    const ENDS: [[usize; 3]; 8] = [[1, 3, 4], [2, 0, 5], [3, 1, 6], [0, 2, 7], [7, 5, 0], [4, 6, 1], [5, 7, 2], [6, 4, 3]];
    let at = |v: u32| -> [f64; 3] { std::array::from_fn(|k| hexes.positions[3 * v as usize + k]) };
    let mut least = f64::INFINITY;
    for hexahedron in &hexes.hexahedra {
        for (corner, ends) in ENDS.iter().enumerate() {
            let from = at(hexahedron[corner]);
            let [a, b, c]: [[f64; 3]; 3] = std::array::from_fn(|e| {
                let to = at(hexahedron[ends[e]]);
                let edge: [f64; 3] = std::array::from_fn(|k| to[k] - from[k]);
                let length = edge.iter().map(|x| x * x).sum::<f64>().sqrt();
                edge.map(|x| x / length)
            });
            let volume = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
            least = least.min(volume);
        }
    }
    least
}

#[test]
fn missing_features_of_hexahedra_have_a_reason() {
    let positions = [1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0];
    let triangles = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];
    let surface = Surface::new(&positions, &triangles).unwrap();
    let mut options = hexmesh::Options::default();
    options.cells = 200;
    options.max_hausdorff_percent = 0.0;
    options.features = orbicube::sys::hexmesh::OBC_HEXMESH_FEATURES_ANGLES;
    options.method = orbicube::sys::hexmesh::OBC_HEXMESH_METHOD_GRID;
    let (kept, report) = hexmesh::fill_with_hexahedra(surface, &options, &mut host()).unwrap();
    assert!(report.embedded == 1 && report.feature_curves == 12 && kept.missing.is_empty());
    options.method = orbicube::sys::hexmesh::OBC_HEXMESH_METHOD_POLYCUBE;
    let (lost, report) = hexmesh::fill_with_hexahedra(surface, &options, &mut host()).unwrap();
    assert!(report.captured < 0.9 && lost.missing.len() == report.missing_features);
    assert!(lost.missing.iter().all(|missing| !missing.why.is_empty() && missing.captured < 0.95));
}

#[test]
fn solids_become_hexahedra_and_polycubes() {
    let (corners, tetrahedra) = cube_of_tetrahedra();
    let mut options = hexmesh::Options::default();
    options.method = sys::hexmesh::OBC_HEXMESH_METHOD_FRAMES;
    options.cells = 8;
    let (hexes, report) = hexmesh::fill_solid_with_hexahedra(&corners, &tetrahedra, &[], &options, &mut host()).unwrap();
    assert_eq!((hexes.hexahedra.len(), hexes.positions.len(), hexes.quads.len()), (8, 3 * 27, 24));
    assert!((report.volume - 1.0).abs() < 1e-9 && report.irregular_edges == 0);
    assert!((min_scaled_jacobian(&hexes) - report.min_scaled_jacobian).abs() < 1e-12 && report.min_scaled_jacobian > 0.99);
    if let Some(program) = std::env::var_os("ORBICUBE_PROBLEMS") {
        let printed = String::from_utf8(std::process::Command::new(program).output().unwrap().stdout).unwrap();
        let line = printed.lines().find(|line| line.starts_with("cube ")).unwrap();
        let bits: Vec<String> = hexes.positions.iter().map(|x| format!("{:016x}", x.to_bits())).collect();
        assert_eq!(line, format!("cube {} {}", hexes.hexahedra.len(), bits.join(" ")));
    }
    let solid = frame_field::Solid::new(&corners, &tetrahedra).unwrap();
    let (frames, _) = frame_field::compute(solid, &Default::default(), &Default::default(), &[], &mut host()).unwrap();
    let (given, _) = hexmesh::fill_solid_with_hexahedra(&corners, &tetrahedra, &frames, &options, &mut host()).unwrap();
    assert!(given.hexahedra.len() == 8 && min_scaled_jacobian(&given) > 0.99);
    assert!(hexmesh::fill_solid_with_hexahedra(&corners, &tetrahedra, &frames[4..], &options, &mut host()).is_err());

    let shape = Mesh::make("cube", 300, 0, &mut host()).unwrap();
    let mut options = hexmesh::Options::default();
    options.cells = 27;
    options.padding = sys::hexmesh::OBC_HEXMESH_PADDING_WITHOUT;
    let (hexes, report) = hexmesh::fill_with_hexahedra(shape.surface(), &options, &mut host()).unwrap();
    assert_eq!((hexes.hexahedra.len(), hexes.positions.len(), hexes.quads.len(), hexes.quad_patches.len()), (27, 3 * 64, 54, 54));
    let volume = mesh::topology(shape.surface(), &mut host()).unwrap().volume;
    assert!((report.volume - volume).abs() < 1e-9 && min_scaled_jacobian(&hexes) > 0.99);
    let cells: Vec<u32> = hexes.hexahedra.concat();
    Mesh::new(&hexes.positions, &[], &[], &cells).unwrap().check_cells(&mut host()).unwrap();
    let cancelled = hexmesh::fill_with_hexahedra(shape.surface(), &options, &mut Host::new().on_progress(|_| false));
    assert!(cancelled.err().unwrap().is_cancelled());

    let mapped = volume_map::map_to_polycube(&corners, &tetrahedra, &Default::default(), &mut host()).unwrap();
    for places in [&mapped.positions, &mapped.polycube] {
        Mesh::new(places, &[], &mapped.tetrahedra, &[]).unwrap().check_cells(&mut host()).unwrap();
    }
    assert!(volume_map::map_to_polycube(&corners, &tetrahedra[1..], &Default::default(), &mut host()).is_err());

    let mut options = volume_map::FrameMapOptions::default();
    options.cell_length = 0.5;
    options.integer = 1;
    let axes: Vec<f64> = (0..tetrahedra.len()).map(|i| if i % 4 == 0 { 1.0 } else { 0.0 }).collect();
    let (map, report) = volume_map::parameterize(&corners, &tetrahedra, &axes, &options, &mut host()).unwrap();
    assert_eq!((report.inverted, report.patches, map.singular_edges.len()), (0, 6, 0));
    for (i, x) in map.parameters.iter().enumerate() {
        let at = |tetrahedron: usize| corners[3 * tetrahedra[tetrahedron] as usize + i % 3];
        assert!((x - map.parameters[i % 3] - 2.0 * (at(i / 3) - at(0))).abs() < 1e-6);
    }
    assert!(volume_map::parameterize(&corners, &tetrahedra, &axes[1..], &options, &mut host()).is_err());

    let locate = |places: &[f64]| volume_map::Locator::new(places, &mapped.tetrahedra, &mut host()).unwrap();
    let point = [0.25, 0.5, 0.875];
    let image = locate(&mapped.positions).sample(&[point, [2.0, 0.0, 0.0]], &mapped.polycube, &mut host()).unwrap();
    assert!(image[3].is_nan());
    let back = locate(&mapped.polycube).sample(&[[image[0], image[1], image[2]]], &mapped.positions, &mut host()).unwrap();
    assert!((0..3).all(|a| (back[a] - point[a]).abs() < 1e-9));
    assert_eq!(locate(&mapped.positions).locate(&[[2.0, 0.0, 0.0]], &mut host()).unwrap()[0].0, u32::MAX);
}

#[test]
fn pointers_that_safe_code_sets_are_not_followed() {
    unsafe extern "C" fn never(_: u64, _: u64, _: f64, _: *mut std::os::raw::c_void) {
        std::process::abort();
    }
    let shape = Mesh::make("sphere", 300, 0, &mut host()).unwrap();
    let mut options = sphere_map::Options::default();
    options.method = sys::sphere_map::OBC_SPHERE_MAP_DISSERTATION;
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
        orbicube::tetrahedra::check_surface(shape.surface(), &mut host()).unwrap();
        let open = Surface::new(shape.positions(), &shape.triangles()[3..]).unwrap();
        assert!(orbicube::tetrahedra::check_surface(open, &mut host()).is_err());
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
