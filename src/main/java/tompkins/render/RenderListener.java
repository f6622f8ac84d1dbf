package tompkins.render;

/**
 * Is told how a render goes on. Called by the threads of the renderer, and by the thread that closes it for jobs that
 * had not begun; must return quickly.
 */
public interface RenderListener {

    /** Nobody. */
    RenderListener NONE = new RenderListener() {};

    /** A part of a pass is done; {@link RenderJob#progress()} has grown. */
    default void tileDone(RenderJob job) {}

    /** A pass over the whole picture is done; {@link RenderJob#image()} shows it. */
    default void passDone(RenderJob job) {}

    /** The job has ended: it is complete, was cancelled, or failed. */
    default void ended(RenderJob job) {}
}
