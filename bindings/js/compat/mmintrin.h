/* Eigen includes it with the headers of SSE2; emscripten has no MMX, and no use of it is made. */
