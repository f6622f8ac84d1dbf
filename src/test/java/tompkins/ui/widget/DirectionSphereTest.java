package tompkins.ui.widget;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Point;
import java.awt.event.MouseEvent;
import java.awt.geom.Point2D;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

class DirectionSphereTest {

    @Test
    void theArrowFollowsTheMouse() {
        Vector3d[] turned = new Vector3d[1];
        DirectionSphere sphere =
                new DirectionSphere((direction, gesture) -> turned[0] = new Vector3d(direction), gesture -> {});
        sphere.setSize(100, 100);
        for (Vector3d wanted : List.of(new Vector3d(0, 1, 0), new Vector3d(0.6, 0, 0.8), new Vector3d(0, 0, 1))) {
            Point2D point = sphere.pointOf(wanted);
            Point pixel = new Point((int) Math.round(point.getX()), (int) Math.round(point.getY()));
            Vector3d far = sphere.at(pixel.x, pixel.y, false);
            Vector3d near = sphere.at(pixel.x, pixel.y, true);
            assertThat(Math.min(far.angle(wanted), near.angle(wanted))).isLessThan(Math.toRadians(12));
            sphere.dispatchEvent(new MouseEvent(
                    sphere, MouseEvent.MOUSE_PRESSED, 0, 0, pixel.x, pixel.y, 1, false, MouseEvent.BUTTON1));
            assertThat(turned[0].length()).isCloseTo(1, within(0.002));
            assertThat(turned[0].angle(far)).isCloseTo(0, within(0.003));
        }
    }
}
