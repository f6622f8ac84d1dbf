package tompkins.sceneobject;

import java.util.Set;
import java.util.stream.Stream;
import tompkins.fuzz.RandomStudio;
import tompkins.property.Descriptions;
import tompkins.surface.Surface;

/** The types of objects that have an inside: all but those that are named here as others. */
public final class ClosedTypes {

    private static final Set<Class<?>> OTHERS = Set.of(
            Plane.class,
            Disc.class,
            Parallelogram.class,
            Triangle.class,
            Silhouette.class,
            CylinderLattice.class,
            Group.class,
            Placed.class,
            Moving.class,
            Rotating.class,
            ImagePointGrid.class,
            Hidden.class);

    private ClosedTypes() {}

    /** Those that must be closed. */
    public static Stream<Class<?>> types() {
        return Descriptions.members(SceneObject.class).stream().filter(type -> !OTHERS.contains(type));
    }

    /** A random closed object of such a type: of cylinders and cones those with ends. */
    static SceneObject random(long seed, Class<?> type, Surface surface) {
        return Stream.iterate(seed * 1000, next -> next + 1)
                .map(next -> RandomStudio.object(next, type, surface))
                .filter(object -> !(object instanceof Cylinder cylinder && !cylinder.caps())
                        && !(object instanceof Cone cone && !cone.base()))
                .findFirst()
                .orElseThrow();
    }
}
