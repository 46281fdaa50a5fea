#!/bin/bash
# A sweep on several machines under Slurm, as an example: sbatch scripts/slurm_sweep.sh SWEEP DIR
# One process per machine, its threads on all cores of it. When the time is over, or a machine is lost, the job is put back into the
# queue and goes on where it was: finished cases are in DIR.
#SBATCH --job-name=railpem
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=1
#SBATCH --cpus-per-task=32
#SBATCH --time=04:00:00
#SBATCH --requeue
#SBATCH --open-mode=append
set -euo pipefail

sweep=${1:?a sweep file}
folder=${2:?a folder that all machines see}
program=${RAILPEM:-railpem} # a build with -DRAILPEM_MPI=ON

export OMP_NUM_THREADS="$SLURM_CPUS_PER_TASK"
export OMP_PROC_BIND=true
srun --mpi=pmix --cpus-per-task="$SLURM_CPUS_PER_TASK" "$program" sweep "$sweep" --out "$folder"
