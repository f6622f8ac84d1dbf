import com.sun.management.OperatingSystemMXBean;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Locale;
import math.SpaceTimeTransformation.SpaceTimeTransformationType;
import math.Vector3D;
import optics.raytrace.GUI.cameras.EditableRelativisticAnyFocusSurfaceCamera;
import optics.raytrace.GUI.cameras.QualityType;
import optics.raytrace.GUI.lowLevel.ApertureSizeType;
import optics.raytrace.GUI.sceneObjects.EditableCylinderLattice;
import optics.raytrace.GUI.sceneObjects.EditableParametrisedPlane;
import optics.raytrace.GUI.sceneObjects.EditableSceneObjectCollection;
import optics.raytrace.cameras.PinholeCamera.ExposureCompensationType;
import optics.raytrace.cameras.shutterModels.AperturePlaneShutterModel;
import optics.raytrace.core.LightSource;
import optics.raytrace.core.SceneObjectClass;
import optics.raytrace.core.Studio;
import optics.raytrace.sceneObjects.solidGeometry.SceneObjectContainer;
import optics.raytrace.surfaces.SurfaceColour;
import tompkins.image.LinearImage;
import tompkins.io.BundledScenes;
import tompkins.render.Renderer;
import tompkins.trace.RenderPlan;

/** Takes two figures of the paper with both programs in turns, each with the threads that Dr TIM takes by itself. */
final class DrTimComparison {

    private static final int PICTURES_IN_TURN = 20;
    private static final PrintStream OUT = System.out;

    private DrTimComparison() {}

    /** Prints a line of Markdown for each figure: medians of the second half of some rounds. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        // Dr TIM tells of each line that it renders
        System.setOut(new PrintStream(OutputStream.nullOutputStream()));
        int rounds = Integer.parseInt(arguments[0]);
        int threads = Math.max(1, Runtime.getRuntime().availableProcessors() - 1);
        OUT.println("Medians of " + rounds + " rounds in turns, 640 x 480, one ray for each pixel, processor time, threads: " + threads);
        OUT.println("| figure | Dr TIM, ms | Tompkins, ms | times as long | mean difference of 8-bit values |\n| --- | --- | --- | --- | --- |");
        compare("fig1a", new Vector3D(0, 0, 0), rounds, threads);
        compare("fig1b", new Vector3D(0.2, -0.1, 0.97), rounds, threads);
    }

    private static void compare(String name, Vector3D beta, int rounds, int threads)
            throws IOException, InterruptedException {
        Studio drTim = drTim(beta);
        tompkins.studio.Studio scene = BundledScenes.studio(name + ".json");
        tompkins.studio.Studio studio = scene.withSettings(scene.settings().withSamples(1));
        double[] theirs = new double[rounds];
        double[] ours = new double[rounds];
        RenderPlan plan = RenderPlan.of(studio);
        double difference = Double.NaN;
        LinearImage picture = null;
        try (Renderer renderer = new Renderer(threads)) {
            for (int round = 0; round < rounds; round++) {
                double start = processorMilliseconds();
                BufferedImage photo = drTim.takePhoto();
                theirs[round] = processorMilliseconds() - start;
                start = processorMilliseconds();
                for (int i = 0; i < PICTURES_IN_TURN; i++) {
                    plan = RenderPlan.of(studio, plan);
                    picture = renderer.render(plan).image();
                }
                ours[round] = (processorMilliseconds() - start) / PICTURES_IN_TURN;
                difference = difference(photo, picture);
            }
        }
        double their = median(Arrays.copyOfRange(theirs, rounds / 2, rounds));
        double our = median(Arrays.copyOfRange(ours, rounds / 2, rounds));
        OUT.printf(Locale.ROOT, "| %s | %.0f | %.1f | %.0f | %.2f |%n", name, their, our, their / our, difference);
    }

    /** How much the pictures differ; Dr TIM takes each ray at a random place of its pixel. */
    private static double difference(BufferedImage theirs, LinearImage ours) {
        double sum = 0;
        for (int row = 0; row < ours.height(); row++) {
            for (int column = 0; column < ours.width(); column++) {
                int rgb = theirs.getRGB(column, row);
                for (int channel = 0; channel < 3; channel++) {
                    int value = rgb >> 16 - 8 * channel & 0xff;
                    sum += Math.abs(value - (int) (255 * Math.min(1, ours.value(column, row, channel))));
                }
            }
        }
        return sum / (3.0 * ours.width() * ours.height());
    }

    /** What this process has used of the processor: nothing else that runs counts. */
    private static double processorMilliseconds() {
        return ((OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean()).getProcessCpuTime() / 1e6;
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }

    /** The scene of {@code fig1a.json}, made of Dr TIM's own objects, without the silhouette far behind. */
    private static Studio drTim(Vector3D beta) {
        Studio studio = new Studio();
        SceneObjectContainer scene = new SceneObjectContainer("scene", null, studio);
        scene.addSceneObject(SceneObjectClass.getChequerboardFloor(scene, studio));
        scene.addSceneObject(SceneObjectClass.getSkySphere(scene, studio));
        scene.addSceneObject(
                new EditableCylinderLattice("lattice", -1.5, 1.5, 4, -1.5, 1.5, 4, -1, 10, 12, 0.02, scene, studio));
        EditableRelativisticAnyFocusSurfaceCamera camera = new EditableRelativisticAnyFocusSurfaceCamera(
                "camera",
                new Vector3D(0, 0, 0),
                new Vector3D(0, 0, 1),
                new Vector3D(0, 1, 0),
                20,
                SpaceTimeTransformationType.LORENTZ_TRANSFORMATION,
                beta,
                640,
                480,
                ExposureCompensationType.EC0,
                1000,
                new EditableParametrisedPlane(
                        "focus", new Vector3D(0, 0, 10), new Vector3D(0, 0, 1), SurfaceColour.BLACK_SHINY, scene, studio),
                new EditableSceneObjectCollection("camera frame", false, scene, studio),
                ApertureSizeType.PINHOLE,
                QualityType.BAD,
                QualityType.NORMAL);
        camera.setShutterModel(new AperturePlaneShutterModel(0));
        studio.setScene(scene);
        studio.setLights(LightSource.getStandardLightsFromBehind());
        studio.setCamera(camera);
        return studio;
    }
}
