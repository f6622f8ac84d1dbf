package tompkins.explain;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tompkins.camera.Camera;
import tompkins.camera.SamplePositions;
import tompkins.light.PointLight;
import tompkins.light.Pulse;
import tompkins.light.RestingLight;
import tompkins.property.NumberText;
import tompkins.studio.Studio;
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

    /** Least cosine between the normals of one flat surface. */
    private static final double PARALLEL = 1 - 1e-12;

    private static final int DIGITS = 4;

    /** Of the ends of spans, so that a picture just outside of them is dark. */
    private static final int FEWEST_DIGITS = 6;

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
        if (onlyFlashes
                && plan.hasFlashes()
                && tried(SamplePositions.MIDDLE).noneMatch(this::isLit)
                && !isLitByTheWay()) {
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
        List<LitSpan> spans = tried(SamplePositions.MIDDLE)
                .filter(FlashSight::isClear)
                .map(this::openingTimes)
                .filter(times -> !times.isEmpty())
                .map(times -> times.get(0))
                .filter(span -> Double.isFinite(span.from()) && Double.isFinite(span.to()))
                .toList();
        if (spans.isEmpty() || !hasOpeningTime()) {
            return Optional.empty();
        }
        double first = spans.stream().mapToDouble(LitSpan::from).min().getAsDouble();
        double[] ends = spans.stream().mapToDouble(LitSpan::to).sorted().toArray();
        double latest = first + LATE * (ends[ends.length / 2] - first);
        return Optional.of(new LitSpan(first, Math.min(latest, ends[ends.length - 1])));
    }

    /** The flashes at all hits of rays that are spread over the picture, after a part of the exposure. */
    private Stream<FlashSight> tried(double moment) {
        return IntStream.range(0, plan.hasFlashes() ? TRIED * TRIED : 0)
                .mapToObj(i -> RayLife.way(
                        plan,
                        (i % TRIED + 0.5) / TRIED * plan.width(),
                        (i / TRIED + 0.5) / TRIED * plan.height(),
                        0,
                        0,
                        moment))
                .filter(life -> life != null)
                .flatMap(life -> life.hits().stream())
                .flatMap(hit -> hit.flashes().stream());
    }

    private boolean isLit(FlashSight sight) {
        double now = now();
        return sight.isClear()
                && (sight.isLit()
                        || openingTimes(sight).stream().anyMatch(times -> times.from() <= now && now < times.to()));
    }

    /** Whether something behind a mirror or glass may be lit in the exposure: no opening times are known for it. */
    private boolean isLitByTheWay() {
        List<FlashSight> first = tried(0).filter(sight -> !sight.isStraight()).toList();
        List<FlashSight> last = tried(1).filter(sight -> !sight.isStraight()).toList();
        return first.size() != last.size()
                || IntStream.range(0, first.size())
                        .filter(i -> first.get(i).isClear() || last.get(i).isClear())
                        .anyMatch(i -> isLitBetween(
                                first.get(i).flash(),
                                first.get(i).emission(),
                                last.get(i).emission()));
    }

    private static boolean isLitBetween(Pulse flash, double one, double other) {
        double sinceBegin = flash.phase(Math.max(one, other));
        return flash.isLit(Math.min(one, other)) || sinceBegin >= 0 && sinceBegin <= Math.abs(one - other);
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
        if (!sight.isClear()) {
            return lamp + "Its light does not reach what the middle of the picture shows.";
        }
        String moment = plan.blursInTime() ? ", in the middle of the exposure," : "";
        return lamp + "What the middle of the picture shows was reached" + moment + " by light that left it at "
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
        List<LitSpan> times = openingTimes(sight);
        if (times.isEmpty()) {
            return " No opening time would light it.";
        }
        String when = times.stream().map(Flashes::fromTo).collect(Collectors.joining(" and "));
        boolean stays = times.stream()
                .flatMapToDouble(span -> DoubleStream.of(span.from(), span.to()))
                .filter(Double::isFinite)
                .allMatch(this::staysInTheMiddle);
        return " It " + (isLit(sight) ? "is" : "would be") + " lit " + when + " (now " + number(now()) + ")"
                + (stays ? "." : ", if the middle still showed that surface.");
    }

    /** Whether the middle shows the same object, and no other point of its surface than one that rests there would. */
    private boolean staysInTheMiddle(double opening) {
        Camera camera = plan.studio().camera();
        Studio opened =
                plan.studio().withCamera(camera.withShutter(camera.shutter().openedAt(opening)));
        RayLife then = RenderPlan.of(opened, plan).middleLife();
        RayLife.Encounter here = plan.middleLife().end();
        return then != null
                && then.end() != null
                && then.end().object().equals(here.object())
                && then.end().rest().normal().dot(here.rest().normal()) > PARALLEL;
    }

    private boolean hasOpeningTime() {
        return plan.studio().camera().shutter().hasOpeningTime();
    }

    private double now() {
        return hasOpeningTime() ? plan.studio().camera().shutter().openingTime() : 0;
    }

    /**
     * The opening times with which a hit is lit in some part of the exposure; of a lamp that flashes again and again,
     * those around the present one or nearest to it.
     */
    private List<LitSpan> openingTimes(FlashSight sight) {
        double exposure = plan.studio().camera().exposureTime();
        double now = now();
        List<LitSpan> joined = new ArrayList<>();
        sight.spans().stream().sorted(Comparator.comparingDouble(LitSpan::from)).forEach(span -> {
            double from = now + span.from() - exposure / 2;
            double to = now + span.to() + exposure / 2;
            LitSpan last = joined.isEmpty() ? null : joined.get(joined.size() - 1);
            if (last != null && from <= last.to()) {
                joined.set(joined.size() - 1, new LitSpan(last.from(), Math.max(last.to(), to)));
            } else {
                joined.add(new LitSpan(from, to));
            }
        });
        return sight.flash().period() == 0
                ? joined
                : joined.stream()
                        .min(Comparator.comparingDouble(
                                times -> Math.max(0, Math.max(times.from() - now, now - times.to()))))
                        .stream()
                        .toList();
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
        return Double.isFinite(before)
                ? Math.min(FEWEST_DIGITS + (int) Math.max(0, before), MOST_DIGITS)
                : FEWEST_DIGITS;
    }

    private static String number(double value) {
        return NumberText.plain(value, DIGITS);
    }
}
