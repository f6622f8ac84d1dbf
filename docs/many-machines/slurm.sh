#!/usr/bin/env bash
# Takes the frames of a film in an array of Slurm jobs, into a folder that all nodes share.
#
#     job=$(sbatch --parsable slurm.sh scene.json --from 0 --to 0.99)
#     sbatch --dependency=afterok:$job --kill-on-invalid-dep=yes --wrap 'tompkins animate --assemble frames -o film.mp4'
#
# The second job makes the film when all tasks of the first have done their part; it is cancelled if one fails for good.
#
#SBATCH --array=0-7
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=frames-%a.log
set -u
code=0
tompkins animate "$@" --part "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
    --threads "$SLURM_CPUS_PER_TASK" --skip-existing -o frames || code=$?
case $code in
    0 | 2 | 3) ;; # done, a mistake, or frames that are missing: trying again changes nothing
    *)
        # a failure of the machine, such as a process that was killed (137); Slurm stops this script when it begins again
        if [ "${SLURM_RESTART_COUNT:-0}" -lt 3 ]; then
            scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
            sleep 30
        fi
        ;;
esac
exit "$code"
