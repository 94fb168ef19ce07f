# shellcheck shell=dash
# Each command, what it prints, and its exit code. The emulator is slow, so the times are long.
cd /tmp || exit 1
bus="--bus socketcan:vcan0 --listen 1500 --timeout 3000 --with 5=/drive-402.eds"

# expect CODE TEXT COMMAND...
expect() {
  code=$1 text=$2
  shift 2
  echo "\$ $*"
  "$@" >printed 2>&1
  found=$?
  cat printed
  if [ $found != "$code" ] || ! grep -q -e "$text" printed; then
    echo "expected $code and '$text', found $found"
    exit 1
  fi
}

expect 2 "cannot open .can7." objdict bus scan --bus socketcan:can7
python3 /node.py 1000 >ready &
node=$!
while ! grep -q ready ready; do
  kill -0 $node || exit 1
  sleep 1
done
candump -L vcan0 >seen.log &
dump=$!

expect 0 "5 *pre-operational" objdict bus scan $bus --nodes 4-6 --log own.log
expect 0 "0x3F9" objdict bus read 5 1018:1 $bus
expect 1 "06020000h" objdict bus read 5 5FFE $bus
expect 0 "1 of 1 value written" objdict bus write 5 1017=400 --yes $bus
expect 0 "axis not named" objdict bus read 5 2000 $bus
expect 0 "1 of 1 value written" objdict bus write 5 "2000=a label that needs several segments" --yes $bus
expect 0 "a label that needs several segments" objdict bus read 5 2000 $bus
expect 0 "drive-402 heartbeat" objdict bus watch --for 5 $bus
expect 0 "pre-operational" objdict bus watch --frames --for 2 $bus
expect 0 "node 5 is operational" objdict bus nmt start 5 --yes $bus

# candump sees each frame of the command exactly once
kill $dump
expect 0 "read 1018:01" objdict decode seen.log --with 5=/drive-402.eds --kind sdo
expect 0 "write 1017:00 .* = 400" objdict decode seen.log --with 5=/drive-402.eds --kind sdo
sent=$(grep -c " 604#" own.log)
if [ "$sent" = 0 ] || [ "$sent" != "$(grep -c " 604#" seen.log)" ]; then
  echo "the log has $sent requests to node 4, candump another number"
  exit 1
fi

kill $node
sleep 1
expect 2 "does not respond" objdict bus read 5 1018:1 $bus
ip link set vcan0 down
expect 2 "adapter\|cannot open" objdict bus read 5 1018:1 $bus
echo "all commands did what they should"
