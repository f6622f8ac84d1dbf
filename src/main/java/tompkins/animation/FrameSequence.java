package tompkins.animation;

import tompkins.studio.Studio;

/** Photographs that follow each other. */
public interface FrameSequence {

    /** Photographs in a second. */
    int frameRate();

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
