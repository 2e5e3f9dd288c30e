# Runs the Julia of a page, block after block, as one program in a folder of its own: julia_samples.jl PAGE.md
page = abspath(ARGS[1])
blocks = [m.captures[1] for m in eachmatch(r"^```julia\n(.*?)^```"ms, read(page, String))]
isempty(blocks) && error("no Julia in $page")
mktempdir() do folder
    cd(folder) do
        for block in blocks
            include_string(Main, block, page)
        end
    end
end
