package tompkins.scenes;

import java.nio.file.Path;
import tompkins.camera.Cameras;
import tompkins.camera.ThinLensCamera;
import tompkins.image.LinearImage;
import tompkins.io.StudioReader;
import tompkins.render.RenderJob;
import tompkins.render.Renderer;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** The scenes that come with the program, for tests. */
final class SceneFiles {

    private SceneFiles() {}

    static Studio read(String name) {
        return StudioReader.read(Path.of("scenes", name + ".json"));
    }

    static Studio withSamples(Studio studio, int samples) {
        return studio.withSettings(studio.settings().withSamples(samples));
    }

    static Studio withAperture(Studio studio, double radius) {
        ThinLensCamera camera = (ThinLensCamera) studio.camera();
        return studio.withCamera(Cameras.lens(
                camera.position(),
                camera.viewDirection(),
                camera.topDirection(),
                camera.horizontalAngleDegrees(),
                camera.verticalAngleDegrees(),
                radius,
                camera.focus(),
                camera.exposureStops(),
                camera.shutter()));
    }

    static LinearImage render(Studio studio) throws InterruptedException {
        return job(studio, 2).image();
    }

    static RenderJob job(Studio studio, int threads) throws InterruptedException {
        try (Renderer renderer = new Renderer(threads)) {
            return renderer.render(RenderPlan.of(studio));
        }
    }
}
