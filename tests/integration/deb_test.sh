#!/bin/sh
# Makes the .deb of the vehicle, and checks what is in it, what it depends on, that its program runs and that systemd
# accepts its unit; where the Python package was built, its .deb likewise.
# usage: deb_test.sh BUILD_DIR. Status 77 where this machine has not the tools.
set -eu
for tool in cpack dpkg-deb dpkg-shlibdeps; do
  command -v $tool > /dev/null || { echo "SKIPPED: $tool is not installed"; exit 77; }
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() { echo "FAILED: $*"; exit 1; }

(cd "$1" && cpack -B "$folder" > "$folder/log" 2>&1) || { cat "$folder/log"; fail "cpack"; }
package=$(ls "$folder"/lookout_*.deb)
dpkg-deb -I "$package"
depends=$(dpkg-deb -f "$package" Depends)
case "$depends" in *liblcm1*) ;; *) fail "no dependency on liblcm1" ;; esac
case "$depends" in *java* | *-jre* | *mrpt-slam* | *mrpt-gui* | *mrpt-obs* | *mrpt-opengl* | *-dev*)
  fail "depends on what a vehicle has no use for: $depends" ;;
esac
if dpkg-deb -c "$package" | grep -E '\.(hpp|a|jar|cmake|py|pyi)$'; then fail "development files in the package"; fi

dpkg-deb -x "$package" "$folder/root"
"$folder/root/usr/bin/lookout" track --help | grep -q 'lookout track' || fail "the program does not run"
for file in bin/lookout lib/systemd/system/lookout-track.service lib/systemd/system/lookout-track@.service share/doc/lookout/copyright share/doc/lookout/lookout.nft; do
  [ -s "$folder/root/usr/$file" ] || fail "no $file"
done
if command -v systemd-analyze > /dev/null; then
  # systemd looks for the program where the unit says that it is; of a template it wants an instance.
  for name in lookout-track lookout-track@; do
    [ "$name" = lookout-track ] && unit=$folder/lookout-track.service || unit=$folder/lookout-track@AUV1.service
    sed "s|/usr/bin/lookout|$folder/root/usr/bin/lookout|" "$folder/root/usr/lib/systemd/system/$name.service" > "$unit"
    systemd-analyze verify --man=no "$unit" > "$folder/said" 2>&1 || { cat "$folder/said"; fail "systemd refuses $name"; }
    [ ! -s "$folder/said" ] || { cat "$folder/said"; fail "systemd has something to say about $name"; }
    systemd-analyze security --offline=true --threshold=15 "$unit" > "$folder/score" 2> /dev/null ||
      { cat "$folder/score"; fail "$name is exposed by more than 1.5"; }
    tail -n 1 "$folder/score"
  done
else
  echo "systemd-analyze is not installed: the unit is not checked"
fi

python_package=$(ls "$folder"/python3-lookout_*.deb 2> /dev/null || true)
if [ -n "$python_package" ]; then
  dpkg-deb -I "$python_package"
  depends=$(dpkg-deb -f "$python_package" Depends)
  for name in 'python3 (>= 3' 'python3 (<< 3' python3-numpy liblcm1; do
    case "$depends" in *"$name"*) ;; *) fail "the Python package does not depend on $name: $depends" ;; esac
  done
  case "$depends" in *-dev* | *java* | *pybind*) fail "the Python package depends on what only a build needs: $depends" ;; esac
  dpkg-deb -x "$python_package" "$folder/python"
  modules=$folder/python/usr/lib/python3/dist-packages
  for file in lookout/__init__.py lookout/__init__.pyi lookout/py.typed lookout/track_t.py lookout_link.py; do
    [ -e "$modules/$file" ] || fail "no $file in the Python package"
  done
  [ -s "$folder/python/usr/share/doc/python3-lookout/copyright" ] || fail "no copyright in the Python package"
  PYTHONPATH=$modules PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c \
    'import lookout; assert "joint" in lookout.tracker_names() and lookout.track_t().id == 0' || fail "the package does not work"
else
  echo "no Python package: it was not built"
fi
echo "passed"
