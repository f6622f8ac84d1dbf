package tompkins.explain;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tompkins.camera.SamplePositions;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.light.RestingLight;
import tompkins.property.NumberText;
import tompkins.trace.FlashSight;
import tompkins.trace.RayLife;
import tompkins.trace.RenderPlan;
import tompkins.world.LitSpan;

/** Says what flash lamps do in a picture, and when something in it is lit. */
public final class Flashes {

    /** Number of rows, and of columns, of the grid of places in the picture that are tried. */
    private static final int TRIED = 16;

    /**
     * Light that comes this many times later than that of half the picture counts as gone: an endless floor is lit for
     * ever.
     */
    private static final double LATE = 3;

    /** Where a flash is shorter than this part of its time, rounding decides where its light begins. */
    private static final double SHORTEST = 1e-9;

    private static final int DIGITS = 4;
    private static final int MOST_DIGITS = 16;

    private final RenderPlan plan;
    private final List<RestingLight> lamps;

    /** The flashes of the picture that is planned. */
    public Flashes(RenderPlan plan) {
        this.plan = plan;
        lamps = plan.world().lights();
    }

    /** A sentence or some for each lamp that flashes, or one for all if none could light what is in the middle. */
    List<String> sentences() {
        List<FlashSight> sights = middle();
        return plan.hasFlashes() && sights.isEmpty()
                ? List.of("Lamps flash, but the middle of the picture shows nothing that they could light.")
                : sights.stream().map(this::sentence).toList();
    }

    /** What may be wrong, in clauses. */
    List<String> warnings() {
        List<String> warnings = new ArrayList<>();
        for (FlashSight sight : middle()) {
            if (sight.flash().duration() < SHORTEST * Math.abs(sight.emission())) {
                warnings.add("the flash of lamp " + sight.lamp() + " is so short beside its time that rounding decides"
                        + " where its light begins and ends");
            }
        }
        boolean onlyFlashes =
                lamps.stream().allMatch(light -> !(light instanceof PointLight) || light.flash() instanceof Pulse);
        if (onlyFlashes && plan.hasFlashes() && tried().noneMatch(FlashSight::isLit)) {
            warnings.add("no flash lights anything in the picture at this opening time"
                    + litTimes()
                            .map(times -> ": something is lit " + fromTo(times))
                            .orElse(""));
        }
        return warnings;
    }

    /**
     * The opening times from the first at which a flash lights something in the picture to one at which most of it is
     * dark again, judged by what is seen now; none if nothing is ever lit.
     */
    public Optional<LitSpan> litTimes() {
        List<LitSpan> spans = tried().flatMap(sight -> sight.spans().stream())
                .filter(span -> Double.isFinite(span.from()) && Double.isFinite(span.to()))
                .toList();
        if (spans.isEmpty() || !hasOpeningTime()) {
            return Optional.empty();
        }
        double first = spans.stream().mapToDouble(LitSpan::from).min().getAsDouble();
        double[] ends = spans.stream().mapToDouble(LitSpan::to).sorted().toArray();
        double latest = first + LATE * (ends[ends.length / 2] - first);
        return Optional.of(opened(new LitSpan(first, Math.min(latest, ends[ends.length - 1]))));
    }

    /** The flashes at all hits of rays that are spread over the picture. */
    private Stream<FlashSight> tried() {
        return IntStream.range(0, plan.hasFlashes() ? TRIED * TRIED : 0)
                .mapToObj(i -> RayLife.way(
                        plan,
                        (i % TRIED + 0.5) / TRIED * plan.width(),
                        (i / TRIED + 0.5) / TRIED * plan.height(),
                        0,
                        0,
                        SamplePositions.MIDDLE))
                .filter(life -> life != null)
                .flatMap(life -> life.hits().stream())
                .flatMap(hit -> hit.flashes().stream());
    }

    private List<FlashSight> middle() {
        RayLife life = plan.hasFlashes() ? plan.middleLife() : null;
        return life == null || life.end() == null ? List.of() : life.end().flashes();
    }

    private String sentence(FlashSight sight) {
        Pulse flash = sight.flash();
        String again = flash.period() == 0 ? "" : ", and again every " + NumberText.of(flash.period());
        String lamp = "Lamp " + sight.lamp() + " flashes for " + NumberText.of(flash.duration()) + " at "
                + NumberText.of(flash.start()) + " of its own time" + again + ". ";
        if (Double.isNaN(sight.emission())) {
            return lamp + "Its light never reaches what the middle of the picture shows.";
        }
        return lamp + "What the middle of the picture shows was reached by light that left it at "
                + number(sight.emission()) + ": " + judgement(flash, sight.emission()) + "." + remedy(sight);
    }

    private static String judgement(Pulse flash, double emission) {
        if (flash.isLit(emission)) {
            return "then it was on";
        }
        double phase = flash.phase(emission);
        double late = phase - flash.duration();
        double early = flash.period() == 0 ? -phase : flash.period() - phase;
        return phase > 0 && (flash.period() == 0 || late < early)
                ? number(late) + " too late"
                : number(early) + " too early";
    }

    /** With which opening times the middle is lit. */
    private String remedy(FlashSight sight) {
        if (!hasOpeningTime() || !sight.isStraight()) {
            return "";
        }
        if (sight.spans().isEmpty()) {
            return " No opening time would light it.";
        }
        String times = sight.spans().stream().map(span -> fromTo(opened(span))).collect(Collectors.joining(" and "));
        return " It " + (sight.isLit() ? "is" : "would be") + " lit " + times + " (now "
                + number(plan.studio().camera().shutter().openingTime()) + ").";
    }

    private boolean hasOpeningTime() {
        return plan.studio().camera().shutter().hasOpeningTime();
    }

    private LitSpan opened(LitSpan span) {
        double now = plan.studio().camera().shutter().openingTime();
        return new LitSpan(now + span.from(), now + span.to());
    }

    private static String fromTo(LitSpan times) {
        int digits = digits(times);
        return "with an opening time from " + NumberText.plain(times.from(), digits)
                + (Double.isInfinite(times.to()) ? " on" : " to " + NumberText.plain(times.to(), digits));
    }

    /** Digits that tell the ends of a span apart: those of its length, and what stands before them. */
    private static int digits(LitSpan times) {
        double largest = Math.max(Math.abs(times.from()), Math.abs(times.to()));
        double before = Math.log10(largest / (times.to() - times.from()));
        return Double.isFinite(before) ? Math.min(DIGITS + (int) Math.max(0, before), MOST_DIGITS) : DIGITS;
    }

    private static String number(double value) {
        return NumberText.plain(value, DIGITS);
    }
}
