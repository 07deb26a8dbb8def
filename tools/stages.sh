# Sourced by the scripts here: headings and timings. stage "name" ends the stage before it.
stage_name=
stage_times=
end_stage() {
  [ -n "$stage_name" ] || return 0
  local line
  line=$(printf '%5d s  %s' $((SECONDS - stage_start)) "$stage_name")
  stage_times+="$line"$'\n'
  echo "-- $line"
  stage_name=
}
stage() {
  end_stage
  stage_name=$1
  stage_start=$SECONDS
  printf '\n== %s\n' "$1"
}
print_times() {
  end_stage
  printf '\n== Time by stage, %d s in all\n%s' "$SECONDS" "$stage_times"
}
jobs() { getconf _NPROCESSORS_ONLN; }
# Output of a long command goes to a file; its end is shown when the command fails.
quietly() {
  local log=$1
  shift
  "$@" >"$log" 2>&1 || { tail -n 100 "$log"; echo "failed: $*" >&2; return 1; }
}
