package tompkins.app;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import tompkins.explain.Explanation;
import tompkins.io.StudioReader;
import tompkins.measure.LessonStudio;
import tompkins.measure.UnseenObjects;
import tompkins.property.MistakeException;
import tompkins.studio.Studio;
import tompkins.trace.RenderPlan;
import tompkins.trace.TouchingSurfaces;

/** Plans the pictures and lessons of scene files. */
final class ScenePlan {

    private ScenePlan() {}

    /** The plan of a picture; an object that cannot be worked with is a mistake in the scene file. */
    static RenderPlan of(Studio studio, Path scene) {
        return of(studio, null, scene);
    }

    /** As above; takes over what it can from the plan of another picture, which may be null. */
    static RenderPlan of(Studio studio, RenderPlan before, Path scene) {
        return StudioReader.used(scene, () -> RenderPlan.of(studio, before));
    }

    /** The warnings of a scene that is checked. */
    static List<String> checked(Studio studio, Path scene) {
        RenderPlan plan = of(studio, scene);
        List<String> warnings = warnings(plan);
        warnings.addAll(new TouchingSurfaces(plan).rivals());
        return warnings;
    }

    /** Prints {@link #warnings}. */
    static void warn(List<String> warnings, PrintWriter err) {
        warnings.forEach(warning -> err.println("warning: " + warning));
    }

    /** What may be wrong with the picture of a plan, and with what is measured in it. */
    static List<String> warnings(RenderPlan plan) {
        List<String> warnings = new ArrayList<>(new Explanation(plan).warnings());
        new UnseenObjects(plan).warning().ifPresent(warnings::add);
        return warnings;
    }

    /** What the lesson of a scene file measures; none is a mistake. */
    static LessonStudio lesson(Studio studio, Path scene) {
        return StudioReader.used(scene, () -> LessonStudio.of(studio))
                .orElseThrow(() -> new MistakeException(scene + ": the scene must have a lesson"));
    }
}
