package tompkins.study;

/** Somebody who wants to know how a study goes on. */
@FunctionalInterface
public interface StudyListener {

    /**
     * Another trial is done.
     *
     * @param measurement its result
     * @param done trials that are done, those of earlier runs included
     * @param all number of trials
     */
    void measured(Measurement measurement, int done, int all);
}
