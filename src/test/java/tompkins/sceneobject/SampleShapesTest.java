package tompkins.sceneobject;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import tompkins.property.Descriptions;
import tompkins.surface.ColouredSurface;

/** A new shape cannot be left out of the samples. */
class SampleShapesTest {

    /** What holds other objects, is made of shapes, or is endless. */
    private static final List<Class<?>> OTHERS = List.of(
            Group.class,
            Moving.class,
            Rotating.class,
            Placed.class,
            Hidden.class,
            Plane.class,
            CylinderLattice.class,
            ImagePointGrid.class,
            Silhouette.class);

    @Test
    void everyShapeHasASample() {
        List<Class<?>> samples = SampleShapes.all(new Vector3d(), 1, ColouredSurface.DEFAULT)
                .<Class<?>>map(SampleShapes::shape)
                .toList();
        assertThat(Descriptions.members(SceneObject.class))
                .as("to be added to SampleShapes")
                .filteredOn(type -> !OTHERS.contains(type))
                .isSubsetOf(samples);
    }
}
