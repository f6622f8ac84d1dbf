package tompkins.animation;

import tompkins.studio.Studio;

/** Photographs that follow each other, {@link #FRAME_RATE} in a second. */
public interface Film {

    /** Photographs in a second of a film in a file. */
    int FRAME_RATE = 25;

    /** Number of photographs. */
    int frames();

    /**
     * What is photographed.
     *
     * @param frame number of the photograph, from 0
     * @throws tompkins.property.InvalidPropertyException if there is no such studio
     */
    Studio studio(int frame);

    /** Says something about a photograph. */
    @FunctionalInterface
    interface Caption {

        /**
         * What is written into a photograph; nothing if it is empty.
         *
         * @param studio what is photographed
         * @param frame number of the photograph, from 0
         */
        String of(Studio studio, int frame);
    }
}
