"""A sweep by Dask, a task a shard, with a worker killed midway: the merged table is the same as without."""
import json, os, signal, subprocess, sys, time
from pathlib import Path

STUDY = """case = "demo/case.toml"
columns = ["loss_w"]
[sample]
method = "sobol"
count = 64
vary."model.boundary_friction" = { uniform = [0.06, 0.10] }
vary."gears.profile_shift.0" = { uniform = [0.0, 0.02] }
"""


def shard(program, study, number, parts):
    command = [program, "sweep", "run", study, "--shard", f"{number}/8", "--parts", parts, "--quiet", "--threads", "1"]
    subprocess.run(command, check=True)
    return number


def total(program, study, parts, place):
    command = [program, "sweep", "merge", study, "--parts", parts, "-o", str(place / "sweep"), "--json"]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)["sha256"]


def main():
    from dask.distributed import Client, LocalCluster

    program, place = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    study = str(place / "study.toml")
    case = (place / "demo" / "case.toml").read_text().replace("face_width", "profile_shift = [0.0, 0.0]\nface_width", 1)
    (place / "demo" / "case.toml").write_text(case)
    Path(study).write_text(STUDY)
    subprocess.run([program, "sweep", "run", study, "--parts", str(place / "whole"), "--quiet"], check=True)
    begin = time.time()
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        tasks = [client.submit(shard, program, study, k, str(place / "dask"), pure=False, retries=5) for k in range(1, 9)]
        time.sleep(1.0)
        victim = next(iter(client.run(os.getpid).values()))
        os.kill(victim, signal.SIGKILL)
        client.gather(tasks)
    same = total(program, study, str(place / "dask"), place) == total(program, study, str(place / "whole"), place)
    print(f"dask, a worker killed midway: {'the same table' if same else 'ANOTHER TABLE'}, {time.time() - begin:.1f} s")
    sys.exit(0 if same else 1)


if __name__ == "__main__":
    main()
