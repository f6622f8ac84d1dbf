package tompkins.animation;

import tompkins.render.RenderReport;

/** Is told how the frames of a film come about. */
@FunctionalInterface
public interface FrameListener {

    /** Does nothing. */
    FrameListener NONE = (frame, state, report) -> {};

    /**
     * A frame has come to a state.
     *
     * @param frame its number, counted from 0
     * @param report how it was taken; null unless it is done
     */
    void reached(int frame, PictureState state, RenderReport report);
}
