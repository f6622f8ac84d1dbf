#!/bin/sh
# Times Dr TIM and Tompkins in one run: Fig. 1(a) and 1(b) of Courtial et al. 2016, 640 x 480, one ray for each pixel.
#
#     src/bench/drtim/compare.sh FOLDER [ROUNDS]
#
# FOLDER is a clone of https://github.com/jkcuk/Dr-TIM at commit 82a3f83, with or without a work tree, or a bare one.
# Needs git, a JDK, and the program: mvn -DskipTests package. Nothing is written but files in a temporary folder.
set -eu
[ $# -ge 1 ] || { echo "compare.sh: needs the folder of a clone of Dr TIM" >&2; exit 2; }
commit=82a3f83
folder=$1
rounds=${2:-7}
here=$(cd "$(dirname "$0")" && pwd)
jar=${TOMPKINS_JAR:-$here/../../../target/tompkins.jar}
[ -f "$jar" ] || { echo "compare.sh: there is no $jar; mvn -DskipTests package makes it" >&2; exit 2; }
git -C "$folder" cat-file -e "$commit^{commit}" 2>/dev/null \
    || { echo "compare.sh: $folder holds no commit $commit of Dr TIM" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Java files and the one library alone: the pictures of other scenes are large
git -C "$folder" ls-tree -r --name-only "$commit" -- src lib | grep -E '\.java$|miglayout.*\.jar$' | while IFS= read -r file; do
    mkdir -p "$work/$(dirname "$file")"
    git -C "$folder" show "$commit:$file" > "$work/$file"
done
mkdir "$work/classes"
javac -nowarn -encoding UTF-8 -d "$work/classes" -cp "$jar:$(ls "$work"/lib/*.jar | tr '\n' ':')" \
    -sourcepath "$work/src" "$here/DrTimComparison.java" 2> "$work/log" || { cat "$work/log" >&2; exit 1; }
echo "Dr TIM $(git -C "$folder" rev-parse "$commit"), $(java -jar "$jar" --version | head -1)"
java -version 2>&1 | head -1
cd "$work"
java -Djava.awt.headless=true -cp "$work/classes:$jar:$(ls "$work"/lib/*.jar | tr '\n' ':')" DrTimComparison "$rounds"
