#!/bin/sh
# Installs the build into a temporary folder, builds programs and a plug-in on find_package(lookout), and runs them:
# the plug-in's estimator and initiator must do in `lookout` what they do by themselves.
# usage: package_test.sh BUILD_DIR PACKAGE_SOURCE_DIR
set -eu
tree=$(cd "$2/../../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

quietly() { "$@" > "$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }; }

fail() { echo "package_test: $1" >&2; exit 1; }

# refused TEXT COMMAND...: exit 2, nothing else, with TEXT in the one line of the message.
refused() {
  text=$1
  shift
  status=0
  "$@" > /dev/null 2> "$folder/refusal" || status=$?
  [ "$status" = 2 ] || fail "expected exit 2, got $status: $*"
  [ "$(wc -l < "$folder/refusal")" = 1 ] || fail "expected one line: $(cat "$folder/refusal")"
  grep -qF -- "$text" "$folder/refusal" || fail "expected '$text' in: $(cat "$folder/refusal")"
}

quietly cmake --install "$1" --prefix "$folder/installed"
quietly cmake -S "$2" -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/installed" -DEXAMPLES="$tree/examples"
quietly cmake --build "$folder/build"
"$folder/build/consumer"
"$folder/build/whole_chain" | grep -q "^scan 20 track 1: north 5[89]" || fail "the whole chain lost its target at 59 m"
test -f "$folder/installed/share/lookout/tools/scenarios/tracking_table7.yaml"

lookout=$folder/installed/bin/lookout
toy=$folder/build/toy.so
scene=$folder/scene.yaml
printf 'duration: 10.0\nvehicle: {}\nsonar: {miss_probability: 0.1, false_alarm_probability: 0.1}\ntargets: []\n' > "$scene"

# The estimator: one element a scan, standing at (30, 40) m.
quietly "$lookout" run "$scene" --plugin "$toy" --estimator toy --tracker csht --out "$folder/run"
scans=$(cut -d, -f1 "$folder/run/scans.csv" | sort -u | wc -l)
awk -F, -v scans=$((scans - 1)) 'NR > 1 && $2 == 30 && $3 == 40 { ++elements }
  END { exit !(elements > 5 && NR == elements + 1) }' "$folder/run/elements.csv" || fail "not the toy's elements"
quietly "$lookout" replay "$folder/run" --plugin "$toy" --estimator toy --tracker csht --out "$folder/replay"
cmp "$folder/run/elements.csv" "$folder/replay/elements.csv"
cmp "$folder/run/tracks.csv" "$folder/replay/tracks.csv"

# The initiator: a track at each scan's first point, as fast as its own key says.
printf 'scan,time_s,x_m,y_m\n0,0,10,20\n1,1,110,20\n2,2,210,20\n' > "$folder/points.csv"
printf 'initiator: {toy_speed: 2.5}\n' > "$folder/toy.yaml"
quietly "$lookout" initiate toy "$folder/points.csv" --plugin "$toy" --config "$folder/toy.yaml" \
  --out "$folder/started.csv"
printf '1,10,20,2.5,0\n2,110,20,2.5,0\n3,210,20,2.5,0\n' > "$folder/expected"
tail -n +2 "$folder/started.csv" | cut -d, -f1-5 | cmp - "$folder/expected"

# As birth method of a tracker, and as a method of an experiment.
printf 'tracker: {name: gnn, initiator: toy}\ninitiator: {toy_speed: 0.5}\n' > "$folder/births.yaml"
quietly "$lookout" run "$scene" --plugin "$toy" --config "$folder/births.yaml" --out "$folder/births"
quietly "$lookout" experiment csht-window --plugin "$toy" --runs 1 --only method=toy --only p_miss=0.1 \
  --only clutter=light --out "$folder/experiment"
grep -q '^toy,' "$folder/experiment/results.csv" || fail "the experiment does not know the toy"

# As a tracker, and beside others in a comparison; its estimator with another tracker.
quietly "$lookout" compare "$scene" --plugin "$toy" --method toy_tracker --method csht:toy --method gnn --runs 2 \
  --out "$folder/compare"
grep -q '^scene,toy_tracker,1,0,' "$folder/compare/curves.csv" || fail "the comparison does not know the toy"
grep -q '"command": "lookout compare .*--plugin' "$folder/compare/results.json" || fail "the plug-in is not told"
refused '--explain: has no effect on tracker toy_tracker' "$lookout" run "$scene" --plugin "$toy" \
  --tracker toy_tracker --explain --out "$folder/none"
refused 'got `toy_tracker`' "$lookout" compare "$scene" --method toy_tracker --out "$folder/none"

# Names: known with the plug-in, unknown without; keys: its own alone.
"$lookout" run --plugin "$toy" --help | grep -q 'ransac toy' || fail "--help does not show the toy"
"$lookout" initiate --plugin "$toy" --help | grep -q 'vct toy' || fail "initiate --help does not show the toy"
refused 'got `toy`, expected one of: joint' "$lookout" run "$scene" --estimator toy --out "$folder/none"
refused 'initiator must be one of ht' "$lookout" initiate toy "$folder/points.csv" --out "$folder/none.csv"
printf 'initiator: {rho_step: 2}\n' > "$folder/unused.yaml"
refused 'unknown key `rho_step`' "$lookout" initiate toy "$folder/points.csv" --plugin "$toy" \
  --config "$folder/unused.yaml" --out "$folder/none.csv"
printf 'initiator: {toy_speed: -1}\n' > "$folder/range.yaml"
refused 'toy_speed' "$lookout" initiate toy "$folder/points.csv" --plugin "$toy" \
  --config "$folder/range.yaml" --out "$folder/none.csv"

# A plug-in that is none.
run_with() { "$lookout" run "$scene" --out "$folder/none" --plugin "$1"; }
refused 'no such file' run_with "$folder/absent.so"
refused 'points.csv: ' run_with "$folder/points.csv"
refused 'lookout_register' run_with "$folder/build/mute.so"
cp "$toy" "$folder/twice.so"
refused 'the estimator `toy` exists already' "$lookout" run "$scene" --out "$folder/none" --plugin "$toy" \
  --plugin "$folder/twice.so"
