package tompkins.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.joml.Vector3d;
import tompkins.property.Descriptions;
import tompkins.ray.Colour;
import tompkins.ray.PixelPicture;
import tompkins.sceneobject.SceneObject;
import tompkins.sceneobject.Sphere;
import tompkins.spacetime.Velocity;
import tompkins.studio.Background;
import tompkins.studio.PanoramaBackground;
import tompkins.studio.Studio;
import tompkins.studio.UniformBackground;
import tompkins.surface.LuminousSurface;

/** Scenes whose light comes from few places that are far smaller than a pixel, so that most samples miss it. */
final class SparseLight {

    private static final int SKY_WIDTH = 2048;
    private static final int SKY_HEIGHT = 1024;
    private static final int STARS = 1500;

    private SparseLight() {}

    /**
     * Four scenes: stars of one pixel before a fast camera, as they are and filtered, and many small and few smaller
     * glowing spheres.
     */
    static Map<String, Studio> scenes(long seed) {
        PixelPicture stars = stars(new SplittableRandom(seed));
        Map<String, Studio> scenes = new LinkedHashMap<>();
        scenes.put("stars", sky(new PanoramaBackground(stars, false)));
        scenes.put("filtered-stars", sky(new PanoramaBackground(stars, true)));
        scenes.put("mist", spheres(new SplittableRandom(seed), 1500, 0.01));
        scenes.put("sparks", spheres(new SplittableRandom(seed), 150, 0.02));
        return scenes;
    }

    private static Studio dark(Background background) {
        Studio without = Descriptions.with(Studio.DEFAULT, "lights", List.of());
        return Descriptions.with(without, "background", background);
    }

    private static Studio sky(Background background) {
        return dark(background).withVelocity(Velocity.of(0, 0, 0.9));
    }

    private static PixelPicture stars(SplittableRandom random) {
        float[] rgba = new float[4 * SKY_WIDTH * SKY_HEIGHT];
        for (int i = 3; i < rgba.length; i += 4) {
            rgba[i] = 1;
        }
        for (int star = 0; star < STARS; star++) {
            int pixel = 4 * random.nextInt(SKY_WIDTH * SKY_HEIGHT);
            for (int channel = 0; channel < 3; channel++) {
                rgba[pixel + channel] = 1;
            }
        }
        return new PixelPicture("stars.png", SKY_WIDTH, SKY_HEIGHT, rgba, new byte[0]);
    }

    /** Spheres in a box that reaches beyond the edges of the picture. */
    private static Studio spheres(SplittableRandom random, int count, double radius) {
        List<SceneObject> spheres = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Vector3d centre =
                    new Vector3d(random.nextDouble(-8, 8), random.nextDouble(-6, 6), random.nextDouble(8, 20));
            spheres.add(new Sphere("light", centre, radius, new LuminousSurface(Colour.WHITE, false)));
        }
        return dark(new UniformBackground(Colour.BLACK)).withScene(spheres);
    }
}
