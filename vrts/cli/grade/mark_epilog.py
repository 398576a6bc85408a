"""What `vrts grade --help` says at its end: examples, clusters, and the other commands."""

EPILOG = """\b
Examples:
  vrts grade examples/01-cans-on-bases -o out
  vrts grade task.toml download.zip -o out
  vrts grade lab1-staff.zip submissions/ -o out --recordings
  vrts grade task.toml anna.v2 ben.v2 --format json
  vrts grade lab1-student.zip mine.v2
  vrts grade task.toml download.zip -o out --export moodle --fill Grades-Lab1.csv
  vrts grade task.toml download.zip -o out --corpus out-2025 --corpus old.zip
  vrts grade task.toml download.zip -o out --backend dask:tcp://192.0.2.1:8786

\b
Clusters (pip install dask dask-jobqueue distributed, here and where the workers are):
  dask:ADDRESS      the workers of that scheduler
  dask              those of Dask's own configuration, else threads of this machine
  slurm, htcondor   --jobs many jobs, as ~/.config/dask/jobqueue.yaml says, for example
                    jobqueue: {slurm: {cores: 1, memory: 2GB, walltime: "01:00:00"}}
                    (htcondor needs disk: 2GB as well); call it where you submit jobs
Workers get pseudonyms and programs, and the task with its hidden checks: use clusters whose
scheduler only you can reach. Without Dask: vrts grade plan, run and merge.

\b
More: vrts grade intake | plan | run | merge | export | init | evidence | reproduce | diff |
change | decisions | desk | similarity, each with --help. Sessions of the live server:
vrts grade [TASK] --session FILE.
"""
