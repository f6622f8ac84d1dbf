package tompkins.studio;

import java.util.List;
import tompkins.lesson.NoLesson;
import tompkins.light.LightSource;

/** Studios with other light sources. */
public final class Lighting {

    private Lighting() {}

    /** The same studio with other light sources. */
    public static Studio of(Studio studio, List<LightSource> lights) {
        return new Studio(
                studio.title(),
                studio.topic(),
                studio.remarks(),
                studio.scene(),
                studio.cameraFrame(),
                lights,
                studio.background(),
                studio.camera(),
                studio.velocity(),
                studio.transformation(),
                studio.view(),
                studio.colours(),
                studio.metering(),
                studio.settings(),
                List.of(),
                NoLesson.DEFAULT);
    }
}
