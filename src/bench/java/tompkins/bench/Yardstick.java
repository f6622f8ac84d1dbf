package tompkins.bench;

import java.util.Locale;

/**
 * What a figure of the paper takes elsewhere: with programs that are not run here, on the machine where they were
 * measured, and with POV-Ray, which was run there and is run here. How it does here tells how fast this machine is.
 *
 * @param figure name of the figure
 * @param drTim milliseconds of Dr TIM
 * @param tree milliseconds of a native scalar tree tracer
 * @param embree milliseconds of Embree with single rays
 * @param packets milliseconds of native packets of sixteen rays
 * @param povRay milliseconds of POV-Ray at 640 x 480
 */
record Yardstick(String figure, double drTim, double tree, double embree, double packets, double povRay) {

    static final Yardstick REST = new Yardstick("fig1a", 4100, 50, 60, 4.3, 172);
    static final Yardstick MOVING = new Yardstick("fig1b", 2100, 18, 24, 1.4, 97);

    static final String HEAD = String.format(Locale.ROOT, """

            ## Machine

            Where Dr TIM, the native tracers and Embree were measured, POV-Ray took %.0f ms for Fig. 1(a) and %.0f ms for Fig. 1(b) at 640 x 480.
            What it takes in this run tells how much slower or faster this machine is; if their times are multiplied by that, this is how
            they compare:

            | figure | POV-Ray here | factor | Dr TIM takes | a native tree takes | Embree takes |
            | --- | --- | --- | --- | --- | --- |
            """, REST.povRay, MOVING.povRay);

    /**
     * A line of the table.
     *
     * @param time milliseconds of this program here
     * @param povRayHere milliseconds of POV-Ray here, in several rounds
     */
    String line(double time, double[] povRayHere) {
        double pov = Measure.median(povRayHere);
        if (Double.isNaN(pov)) {
            return "| " + figure + " | not installed | | | | |\n";
        }
        double factor = pov / povRay;
        return "| " + figure + " | " + Measure.number(pov) + " ms | " + Measure.number(factor) + " | "
                + times(factor * drTim / time) + times(factor * tree / time)
                + times(factor * embree / time).stripTrailing() + "\n";
    }

    /**
     * How much longer this program takes than native packets of sixteen rays would take here.
     *
     * @param time milliseconds of this program here
     * @param povRayHere milliseconds of POV-Ray here, in several rounds
     */
    Measure againstPackets(double time, double[] povRayHere) {
        double pov = Measure.median(povRayHere);
        String what = figure + " against native 16-wide packets, by way of POV-Ray's time here and there";
        return Double.isNaN(pov)
                ? Measure.missing(Measure.Kind.RATIO, what, PovRay.MISSING)
                : Measure.ratioAtMost(what, 5, "x", time / (pov / povRay * packets));
    }

    private static String times(double factor) {
        return Measure.number(factor) + " x | ";
    }
}
