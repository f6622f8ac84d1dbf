package tompkins.lab;

import java.nio.file.Path;
import java.util.List;
import org.joml.Vector3dc;
import tompkins.trace.RenderPlan;
import tompkins.trace.SampleHistory;

/** A program of its own that follows the ray in the middle of some scenes, whose types another jar may have added. */
final class ExtensionProbe {

    /** On the edge of the lens, in units of its radius. */
    private static final double[][] LENS = {{0, 0}, {0.6, 0.8}};

    private ExtensionProbe() {}

    /** Prints two lines for each scene, for the centre of the lens and for its edge: its time, and what is hit. */
    public static void main(String[] scenes) {
        for (String scene : scenes) {
            RenderPlan plan = RenderPlan.of(Lab.read(Path.of(scene)));
            double x = plan.studio().settings().width() / 2.0;
            double y = plan.studio().settings().height() / 2.0;
            for (double[] lens : LENS) {
                SampleHistory life = SampleHistory.of(plan, x, y, lens[0], lens[1]);
                System.out.println(life.cameraStart().time() + numbers(life.mainHits()));
            }
        }
    }

    /** Place and normal of each hit. */
    private static String numbers(List<SampleHistory.Encounter> hits) {
        StringBuilder numbers = new StringBuilder();
        for (SampleHistory.Encounter hit : hits) {
            for (Vector3dc each : List.of(hit.event().position(), hit.rest().normal())) {
                numbers.append(' ')
                        .append(each.x())
                        .append(' ')
                        .append(each.y())
                        .append(' ')
                        .append(each.z());
            }
        }
        return numbers.toString();
    }
}
