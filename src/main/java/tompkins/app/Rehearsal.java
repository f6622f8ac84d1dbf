package tompkins.app;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import tompkins.image.PhotographFile;
import tompkins.image.PictureFormat;
import tompkins.io.SelfDescription;
import tompkins.io.StudioReader;
import tompkins.render.RenderFailedException;
import tompkins.render.RenderJob;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/**
 * Takes a tiny photograph while the command line is read, and throws it away: by then Java has loaded what the real one
 * needs. This saves a tenth of the time of a start.
 */
final class Rehearsal {

    private static final String SCENE =
            "{\"scene\": [{\"type\": \"Sphere\"}], \"settings\": {\"width\": 32, \"height\": 32, \"samples\": 1}}";

    /** With less memory, in bytes, the scene may need what the rehearsal takes. */
    private static final long LEAST_MEMORY = 200L << 20;

    private Rehearsal() {}

    /** Begins it on a thread of its own, if there is memory for both. */
    static void begin() {
        if (Runtime.getRuntime().maxMemory() < LEAST_MEMORY) {
            return;
        }
        Thread thread = new Thread(Rehearsal::takePhotograph, "tompkins-rehearsal");
        thread.setDaemon(true);
        thread.start();
    }

    /** Does what the real photograph does, as far as it is the same for all. */
    static void takePhotograph() {
        Studio studio = StudioReader.read(SCENE, "rehearsal", Path.of("."));
        try (Renderer renderer = new Renderer(1)) {
            RenderJob job = renderer.render(RenderPlan.of(studio));
            PhotographFile.encode(
                    OutputStream.nullOutputStream(),
                    job.image(),
                    PictureFormat.PNG,
                    studio.settings().toneCurve(),
                    SelfDescription.of(studio));
            job.report();
        } catch (IOException | InterruptedException | RenderFailedException | OutOfMemoryError failure) {
            // the photograph itself will tell
        }
    }
}
