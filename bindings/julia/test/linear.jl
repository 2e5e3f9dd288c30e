"The Laplacian of an n by n grid plus 1/100."
function grid_matrix(n)
    path = spdiagm(-1 => -ones(n - 1), 0 => [1; fill(2, n - 2); 1], 1 => -ones(n - 1))
    unit = sparse(1.0 * (1:n .== (1:n)'))
    kron(path, unit) + kron(unit, path) + 0.01 * kron(unit, unit)
end

@testset "sparse symmetric systems by factors" begin
    A = grid_matrix(9)
    n = size(A, 1)
    b = [sin(3i + j) for i in 1:n, j in 1:3]
    factor = LinearFactor(A)
    @test A * (factor \ b) ≈ b atol = 1e-12
    @test solve(factor, b[:, 2]) == (factor \ b)[:, 2]
    @test size(factor) == (n, n) && entry_count(factor) >= nnz(A) ÷ 2 - n ÷ 2
    lower = sparse([A[i, j] for i in 1:n, j in 1:n] .* ((1:n) .>= (1:n)'))
    for same in (Matrix(A), lower, Matrix(lower))
        @test LinearFactor(same; method=:eigen) \ b == LinearFactor(A; method=:eigen) \ b
    end

    # A row that becomes known, and a matrix of rank one.
    remove_row!(factor, 41)
    held = copy(A)
    held[41, :] .= 0
    held[:, 41] .= 0
    held[41, 41] = 1
    @test held * (factor \ b) ≈ b atol = 1e-12
    @test (factor \ b)[41, :] == b[41, :]
    w = zeros(n)
    w[[12, 13]] = [3, -2]
    update!(factor, [12, 13], [3, -2])
    @test (held + w * w') * (factor \ b) ≈ b atol = 1e-11
    update!(factor, [13, 12], [-2, 3]; sign=-1)
    @test held * (factor \ b) ≈ b atol = 1e-11
    refactor!(factor, 2A)
    @test 2A * (factor \ b) ≈ b atol = 1e-12
    fewer = Matrix(A)
    fewer[2, 1] = fewer[1, 2] = 0
    @test fewer * (refactor!(factor, fewer) \ b) ≈ b atol = 1e-12

    @test_throws ArgumentError LinearFactor([2 1; 0.5 3])
    @test_throws ArgumentError LinearFactor([2 1; 0 3])
    @test_throws ArgumentError LinearFactor([2.0 0; 1 0])
    @test_throws DimensionMismatch LinearFactor([2.0 0 0; 1 0 0])
    @test_throws ArgumentError LinearFactor(A; method=:eigenvalues)
    @test_throws OrbicubeError LinearFactor([1.0 2; 2 1])
    @test_throws OrbicubeError LinearFactor([1.0 NaN; NaN 1])
    @test_throws ArgumentError remove_row!(factor, 0)
    @test_throws ArgumentError remove_row!(factor, n + 1)
    @test_throws ArgumentError update!(factor, [0], [1.0])
    @test_throws ArgumentError update!(factor, [1], [1.0]; sign=2)
    @test_throws OrbicubeError update!(factor, [1, n], [1.0, 1])
    @test_throws DimensionMismatch factor \ b[2:end, :]
    fuller = Matrix(A)
    fuller[n, 1] = fuller[1, n] = 0.1
    @test_throws ArgumentError refactor!(factor, fuller)
    @test_throws OrbicubeError update!(factor, [1], [100.0]; sign=-1)
    @test_throws OrbicubeError factor \ b
    @test A * (refactor!(factor, A) \ b) ≈ b atol = 1e-12
end

@testset "sparse symmetric systems by iterations" begin
    A = grid_matrix(150)
    n = size(A, 1)
    b = [sin(3.0i) for i in 1:n]
    length_of(v) = sqrt(sum(abs2, v))
    for method in (:auto, :gauss_seidel, :multigrid), block_size in (1, 2, 3)
        x, report = solve(LinearIterations(A; method=method, block_size=block_size, tolerance=1e-10), b)
        reached = length_of(b - A * x) / length_of(b)
        @test report.converged == 1 && reached < 1.001e-10
        @test report.residual ≈ reached rtol = 1e-2
    end
    one, two = (solve(LinearIterations(A; threads=threads), b)[1] for threads in 1:2)
    @test bits(one) == bits(two)
    _, report = solve(LinearIterations(A; method=:gauss_seidel, max_iterations=2), b)
    @test report.converged == 0 && report.iterations == 2 && report.residual > 1e-8

    # Each call has a function of its own, also after a garbage collection.
    told = Dict(:made => 0, :solved => 0)
    solver = LinearIterations(A; progress=(at...) -> (told[:made] += 1; true))
    made = told[:made]
    GC.gc()
    x, _ = solve(solver, b; progress=(at...) -> (told[:solved] += 1; true))
    @test made > 0 && told[:made] == made && told[:solved] > 0
    cancelled = try solve(solver, b; progress=(at...) -> false) catch error; error end
    @test cancelled isa OrbicubeError && cancelled.kind == "cancelled"
    @test_throws DivideError solve(solver, b; progress=(at...) -> throw(DivideError()))
    @test bits(solve(solver, b)[1]) == bits(x)

    @test_throws DimensionMismatch solve(solver, b[2:end])
    @test_throws OrbicubeError LinearIterations(A; block_size=4)
    @test_throws OrbicubeError LinearIterations(A; tolerance=2)
    @test_throws ArgumentError LinearIterations([2 1; 0 3.0])
end
