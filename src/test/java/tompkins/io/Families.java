package tompkins.io;

import java.util.List;
import tompkins.camera.Camera;
import tompkins.lesson.LessonPlan;
import tompkins.lesson.Measurement;
import tompkins.lesson.MeasuringPoint;
import tompkins.light.Flash;
import tompkins.light.LightSource;
import tompkins.sceneobject.SceneObject;
import tompkins.shutter.Shutter;
import tompkins.studio.Background;
import tompkins.surface.Surface;

/** The families of descriptions that scene files hold. */
public final class Families {

    /** Families of parts, each with several types. */
    public static final List<Class<?>> ALL = List.of(
            SceneObject.class,
            Surface.class,
            LightSource.class,
            Flash.class,
            Shutter.class,
            Camera.class,
            Background.class,
            LessonPlan.class,
            Measurement.class,
            MeasuringPoint.class);

    private Families() {}
}
