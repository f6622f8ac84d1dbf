package tompkins.app;

import java.nio.file.Path;
import tompkins.property.InvalidPropertyException;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;

/** Plans the pictures of scene files. */
final class ScenePlan {

    private ScenePlan() {}

    /** The plan of a picture; an object that cannot be worked with is a mistake in the scene file. */
    static RenderPlan of(Studio studio, Path scene) {
        try {
            return RenderPlan.of(studio);
        } catch (InvalidPropertyException object) {
            throw new MistakeException(scene + ": " + object.getMessage());
        }
    }
}
