package tompkins.camera;

/** The concentric map of the unit square to the unit disc (Shirley and Chiu 1997), which keeps fractions of areas. */
public final class ConcentricMap {

    private ConcentricMap() {}

    /** The radius of the point that belongs to (s, t); with a sign, so that together with the angle it is the point. */
    public static double radius(double s, double t) {
        double a = 2 * s - 1;
        double b = 2 * t - 1;
        return Math.abs(a) > Math.abs(b) ? a : b;
    }

    /** The angle of the point that belongs to (s, t), in radians. */
    public static double angle(double s, double t) {
        double a = 2 * s - 1;
        double b = 2 * t - 1;
        if (Math.abs(a) > Math.abs(b)) {
            return Math.PI / 4 * (b / a);
        }
        return b == 0 ? 0 : Math.PI / 2 - Math.PI / 4 * (a / b);
    }
}
