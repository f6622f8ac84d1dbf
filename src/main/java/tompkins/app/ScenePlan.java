package tompkins.app;

import java.nio.file.Path;
import tompkins.io.StudioReader;
import tompkins.property.InvalidPropertyException;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Plans the pictures of scene files. */
final class ScenePlan {

    private ScenePlan() {}

    /** The plan of a picture; an object that cannot be worked with is a mistake in the scene file. */
    static RenderPlan of(Studio studio, Path scene) {
        return of(studio, null, scene);
    }

    /** As above; takes over what it can from the plan of another picture, which may be null. */
    static RenderPlan of(Studio studio, RenderPlan before, Path scene) {
        try {
            return RenderPlan.of(studio, before);
        } catch (InvalidPropertyException object) {
            throw StudioReader.mistake(scene, object);
        }
    }
}
