package tompkins.trace;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import tompkins.camera.EyeView;
import tompkins.camera.PictureRays;
import tompkins.light.ColourLaw;
import tompkins.light.LightShift;
import tompkins.light.Star;
import tompkins.light.StarCatalogue;
import tompkins.ray.Colour;
import tompkins.ray.Ray;
import tompkins.studio.StarSky;
import tompkins.studio.Studio;
import tompkins.world.FrameAppearance;

/**
 * The stars of a sky, ready for one picture. Immutable, shared by all threads.
 *
 * <p>A star has no size that can be seen, so its light is a flux, not a radiance. Spectral radiance divided by the cube
 * of the frequency is the same in all frames, and the solid angle of a narrow bundle grows by D^-2 from the scene to
 * the camera, where D is the Doppler factor. So the flux over all wavelengths grows by D^2 (docs/physics.md).
 */
final class StarField {

    private final StarSky sky;
    private final PictureRays pictures;
    private final LightShift shift;
    private final double[] solidAngles;
    private final double[] temperatures;
    private final Colour[] atRest;
    private final StarMap map;

    /** In the picture of each eye; null if rays come in another way. */
    private final List<StarPoints> points;

    /**
     * The stars of a picture.
     *
     * @param isDirect whether rays that meet nothing come straight from the sky, through one point of the lens, and in
     *     vacuum
     * @param shift what becomes of the light, or null if it stays as it is
     */
    StarField(StarSky sky, Studio studio, PictureRays pictures, boolean isDirect, LightShift shift) {
        this.sky = sky;
        this.pictures = pictures;
        this.shift = shift;
        List<Star> stars = StarCatalogue.upTo(sky.limit());
        solidAngles = stars.stream().mapToDouble(sky::solidAngle).toArray();
        temperatures = stars.stream().mapToDouble(Star::temperature).toArray();
        atRest = stars.stream()
                .map(star -> ColourLaw.UNCHANGED.ofBlackBody(star.temperature(), 1))
                .toArray(Colour[]::new);
        List<Vector3d> directions = stars.stream().map(sky::direction).toList();
        map = new StarMap(directions);
        points = isDirect ? points(studio, directions) : null;
    }

    private List<StarPoints> points(Studio studio, List<Vector3d> directions) {
        FrameAppearance scene = new FrameAppearance(studio, null);
        List<Vector3d> looks = new ArrayList<>();
        List<Colour> lights = new ArrayList<>();
        for (int star = 0; star < directions.size(); star++) {
            Vector3d look = scene.look(directions.get(star));
            double dopplerFactor = shift == null ? 1 : scene.dopplerFactorAlong(directions.get(star));
            looks.add(look);
            lights.add(light(star, dopplerFactor, 1 / dopplerFactor)
                    .times(solidAngles[star] / (dopplerFactor * dopplerFactor)));
        }
        return pictures.views().stream()
                .map(eye -> new StarPoints(eye.rays(), eye.width(), eye.height(), looks, lights))
                .toList();
    }

    /** The radiance of a star, as the camera sees it, in units of that of white in its rest frame. */
    private Colour light(int star, double dopplerFactor, double directionLength) {
        return shift == null ? atRest[star] : shift.ofBlackBody(temperatures[star], dopplerFactor, directionLength);
    }

    /** The light between the stars, as the camera sees it along a ray. */
    Colour between(Ray ray) {
        return shift == null ? sky.colour() : shift.seen(sky.colour(), ray, 1);
    }

    /** Whether a ray that leaves the scene comes straight from the sky, so that its pixel is all that matters. */
    boolean isDirect(Ray ray) {
        return points != null && ray.depth == 0;
    }

    /** The light of stars that gets straight into a pixel of an eye's picture. */
    Colour direct(EyeView eye, int column, int row) {
        return points.get(pictures.number(eye)).light(column, row);
    }

    /** Visits the stars whose distance from the direction of a ray that leaves the scene is below a radius. */
    void visit(Ray ray, double radius, StarMap.Visitor visitor) {
        map.visit(ray.dx, ray.dy, ray.dz, radius, visitor);
    }

    /** How bright a star is at rest, to be compared with others. */
    double brightness(int star) {
        return atRest[star].luminance() * solidAngles[star];
    }

    /** The light of a star that a ray brings which leaves the scene in its direction: radiance times solid angle. */
    Colour light(int star, Ray ray) {
        // windows leave the light of a star as it is, as the motion does that they imitate, unless light is shifted
        double turned = ray.windowFactor * (shift == null ? ray.directionLength : 1);
        return light(star, 1 / ray.frequency, ray.directionLength).times(solidAngles[star] / (turned * turned));
    }

    /** The solid angle of a pixel of an eye's picture, in steradians. */
    double solidAngle(EyeView eye, int column, int row) {
        return eye.rays().solidAngle(column, row);
    }
}
