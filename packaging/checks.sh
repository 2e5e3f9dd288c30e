# Sourced by the scripts beside it: named checks, their seconds, and a last line that counts them.
passed=0
failed=0

# check NAME COMMAND...: runs the command in a process of its own up to its first failure, and prints what it printed where it fails.
# `outcome` is passed or failed then.
check() {
  local name=$1 started=$EPOCHREALTIME log status
  shift
  log=$(mktemp)
  set +e
  (
    set -e
    "$@"
  ) >"$log" 2>&1
  status=$?
  set -e
  if ((status == 0)); then
    outcome=passed
    passed=$((passed + 1))
  else
    outcome=failed
    failed=$((failed + 1))
    tail -n 60 "$log"
  fi
  awk -v outcome="$outcome" -v name="$name" -v a="$started" -v b="$EPOCHREALTIME" 'BEGIN { printf "%s: %s, %.1f s\n", outcome, name, b - a }'
  rm -f "$log"
}

# say_size FILE...: names and bytes.
say_size() { stat --format '%n, %s bytes' "$@" | sed 's|^.*/||'; }

# The last line; its status is that of all checks.
counted() {
  echo "$passed passed, $failed failed"
  ((failed == 0))
}
