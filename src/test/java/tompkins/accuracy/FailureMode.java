package tompkins.accuracy;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import tompkins.camera.NaiveThinLens;
import tompkins.sceneobject.HitMethod;
import tompkins.sceneobject.NaiveHits;
import tompkins.shutter.LensRay;
import tompkins.spacetime.Event;
import tompkins.spacetime.LorentzTransformation;
import tompkins.spacetime.NaiveFrames;
import tompkins.spacetime.PreciseEvent;
import tompkins.spacetime.SpeedScale;
import tompkins.spacetime.Velocity;
import tompkins.surface.NaiveRefraction;
import tompkins.surface.Refraction;

/**
 * A place where the textbook's form loses its digits.
 *
 * @param quantity what is worked out, and its naive form
 * @param where the numbers for which it fails
 * @param naive error of the naive form: relative, unless the quantity says otherwise; infinite if it gives no number
 * @param ours error of the program
 */
record FailureMode(String quantity, String where, double naive, double ours) {

    static List<FailureMode> all() {
        return List.of(
                fixedPointTime(0),
                fixedPointTime(1e-9),
                gammaOfASpeed(),
                aberrationPole(1e3),
                aberrationPole(1e6),
                farCamera(1e6),
                farCamera(1e12),
                farSphere(1e8),
                farSphere(1e12),
                grazedSphere(),
                selfHits(),
                nearlyEqualMedia(),
                focalPlane(),
                farTile());
    }

    String row() {
        return "| " + quantity + " | " + where + " | " + AccuracyReport.number(naive) + " | "
                + AccuracyReport.number(ours) + " |";
    }

    private static FailureMode fixedPointTime(double speed) {
        Vector3d place = new Vector3d(0, 0, 2);
        double exact = -speed * (1 + speed * speed / 4);
        double ours = new LorentzTransformation(Velocity.of(0, 0, speed)).fixedPointTime(place);
        double naive = NaiveFrames.fixedPointTime(new Vector3d(0, 0, speed), place);
        return of(
                "time of the fixed-point surface, (1 - gamma)(beta.x)/(gamma beta^2)",
                speed == 0 ? "at rest" : "speed " + speed,
                relative(naive, exact),
                relative(ours, exact));
    }

    private static FailureMode gammaOfASpeed() {
        double lacks = 0x1p-27;
        double exact = 1 / Math.sqrt(lacks * (2 - lacks));
        double speed = 1 - lacks / 3;
        double third = 1 - speed;
        double exactThird = 1 / Math.sqrt(third * (2 - third));
        double naive = Math.max(
                relative(1 / Math.sqrt(1 - speed * speed), exactThird),
                relative(1 / Math.sqrt(1 - (1 - lacks) * (1 - lacks)), exact));
        double ours = relative(Velocity.of(0, 0, speed).gamma(), exactThird);
        return of("gamma, 1/sqrt(1 - b^2)", "1 - b about 2.5e-9", naive, ours);
    }

    private static FailureMode aberrationPole(double gamma) {
        Velocity velocity = Velocity.of(SpeedScale.GAMMA, gamma, new Vector3d(0, 0, 1));
        double worstNaive = 0;
        double worstOurs = 0;
        for (double angle : new double[] {1e-12, 1e-10, 1e-9, 1e-8}) {
            Vector3d result = new Vector3d();
            new LorentzTransformation(velocity).direction(new Vector3d(Math.sin(angle), 0, Math.cos(angle)), result);
            double exact = 2 * Math.atan2((gamma + velocity.properSpeed()) * Math.sin(angle / 2), Math.cos(angle / 2));
            worstOurs = Math.max(worstOurs, relative(Math.atan2(result.x, result.z), exact));
            worstNaive = Math.max(worstNaive, relative(NaiveFrames.sceneAngle(velocity.speed(), angle), exact));
        }
        return of(
                "scene angle, acos((cos t - b)/(1 - b cos t))",
                "gamma " + (long) gamma + ", t from 1e-12 to 1e-8",
                worstNaive,
                worstOurs);
    }

    private static FailureMode farCamera(double time) {
        double gamma = 10.5;
        Velocity velocity = Velocity.of(SpeedScale.GAMMA, gamma, new Vector3d(0, 0, 1));
        LorentzTransformation sceneFromCamera = new LorentzTransformation(velocity);
        BigDecimal proper =
                new BigDecimal(gamma).pow(2).subtract(BigDecimal.ONE).sqrt(new MathContext(60));
        BigDecimal place = proper.multiply(new BigDecimal(time));
        Event near = new Event(0, 0, Math.rint(place.doubleValue()), 0);
        double exact = place.subtract(new BigDecimal(near.z())).doubleValue();
        Event lens = new Event(0, 0, 0, time);
        double naive = sceneFromCamera.transform(lens).minus(near).z();
        double ours = sceneFromCamera
                .transform(PreciseEvent.of(lens))
                .minus(near)
                .rounded()
                .z();
        return of(
                "place of the lens relative to objects beside it, in scene coordinates; absolute",
                "camera time " + time,
                Math.abs(naive - exact),
                Math.abs(ours - exact));
    }

    private static FailureMode farSphere(double distance) {
        return of(
                "hits of a sphere, b^2 - a c; fraction of the hits that are lost or wrong by 1 %",
                "distance " + distance + " radii",
                lostHits(new NaiveHits(), distance),
                lostHits(HitMethod.PROGRAM, distance));
    }

    private static double lostHits(HitMethod method, double distance) {
        SplittableRandom random = new SplittableRandom(11);
        int lost = 0;
        for (int i = 0; i < 1000; i++) {
            Vector3d towards = unit(random);
            Vector3d aside =
                    towards.cross(unit(random), new Vector3d()).normalize().mul(0.9 * random.nextDouble());
            Vector3d origin = new Vector3d(towards).mul(-distance).add(aside);
            double found = method.sphere(origin, towards, new Vector3d(), 1, false);
            double depth = Math.sqrt(1 - aside.lengthSquared());
            lost += Math.abs(found - (distance - depth)) < 0.01 + 1e-15 * distance ? 0 : 1;
        }
        return lost / 1000.0;
    }

    private static FailureMode grazedSphere() {
        double miss = 1 - 1e-12;
        double exact = Math.sqrt((1 - miss) * (1 + miss));
        Vector3d origin = new Vector3d(miss, 0, -10);
        Vector3d along = new Vector3d(0, 0, 1);
        double naive = 10 - new NaiveHits().sphere(origin, along, new Vector3d(), 1, false);
        double ours = 10 - HitMethod.PROGRAM.sphere(origin, along, new Vector3d(), 1, false);
        return of(
                "half the chord of a grazing ray",
                "1e-12 radii below the edge",
                relative(naive, exact),
                relative(ours, exact));
    }

    private static FailureMode selfHits() {
        SplittableRandom random = new SplittableRandom(5);
        int naive = 0;
        int ours = 0;
        Vector3d centre = new Vector3d(100, -200, 300);
        for (int i = 0; i < 2000; i++) {
            Vector3d normal = unit(random);
            Vector3d place = new Vector3d(normal).mul(1e4).add(centre);
            Vector3d d = unit(random);
            double chord = Math.max(0, -2e4 * normal.dot(d));
            naive += isSelfHit(new NaiveHits().sphere(place, d, centre, 1e4, true), chord) ? 1 : 0;
            ours += isSelfHit(HitMethod.PROGRAM.sphere(place, d, centre, 1e4, true), chord) ? 1 : 0;
        }
        return of(
                "rays that start on a sphere and hit their own start; fraction",
                "radius 1e4",
                naive / 2000.0,
                ours / 2000.0);
    }

    private static boolean isSelfHit(double distance, double chord) {
        return distance < Double.POSITIVE_INFINITY && distance < chord / 2 + 1e-6;
    }

    private static FailureMode nearlyEqualMedia() {
        double cosine = 1e-4;
        Vector3d d = new Vector3d(Math.sqrt((1 - cosine) * (1 + cosine)), 0, -cosine);
        double ratio = 1 + 1e-12;
        // the squared cosine grows by 1 - 1/ratio^2 = 2e-12 to first order
        double excess = ratio - 1;
        double exact = Math.sqrt(cosine * cosine + excess * (2 + excess) / (ratio * ratio) * d.x * d.x);
        Vector3d bent = new Vector3d();
        Refraction.bend(d, new Vector3d(0, 0, 1), 1, ratio, bent);
        double naive = -NaiveRefraction.bend(d, new Vector3d(0, 0, 1), 1, ratio).z;
        return of(
                "refracted cosine, a difference of cosines",
                "indices 1e-12 apart, cosine 1e-4",
                relative(naive, exact),
                relative(-bent.z, exact));
    }

    private static FailureMode focalPlane() {
        Vector3dc axis = new Vector3d(0, 0, 1);
        Vector3d d = new Vector3d(0.1, 0, 1).normalize();
        Vector3d offset = new Vector3d(0.2, 0, 0);
        Vector3d naive = NaiveThinLens.bend(d, axis, offset, 0.5, 2);
        Vector3d ours = new LensRay(new Vector3d(), offset, d, 0.5 * d.dot(axis), axis).towardsFocus();
        double exact = 0.1 - 0.2 * 0.5;
        return of(
                "slope behind a thin lens, through the image of a point; absolute",
                "the point lies in the focal plane",
                Math.abs(naive.x / naive.z - exact),
                Math.abs(ours.x / ours.z - exact));
    }

    private static FailureMode farTile() {
        double x = 1e12 + 1.5;
        double naive = (int) Math.floor(x) % 2 == (int) Math.floor(x + 1) % 2 ? 1 : 0;
        double ours = Math.abs(Math.floor(x) % 2) == Math.abs(Math.floor(x + 1) % 2) ? 1 : 0;
        return of(
                "tiles that are next to each other and of one colour, by (int) floor(x); fraction",
                "x = 1e12",
                naive,
                ours);
    }

    private static FailureMode of(String quantity, String where, double naive, double ours) {
        return new FailureMode(quantity, where, Double.isNaN(naive) ? Double.POSITIVE_INFINITY : naive, ours);
    }

    private static double relative(double value, double exact) {
        return value == exact ? 0 : Math.abs(value - exact) / Math.abs(exact);
    }

    private static Vector3d unit(SplittableRandom random) {
        Vector3d vector = new Vector3d(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
        return vector.normalize();
    }
}
