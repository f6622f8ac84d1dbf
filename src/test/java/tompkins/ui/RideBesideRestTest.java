package tompkins.ui;

import java.util.List;
import java.util.function.BooleanSupplier;
import org.joml.Vector3d;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import tompkins.sceneobject.Sphere;
import tompkins.shutter.AperturePlaneShutter;
import tompkins.spacetime.Velocity;
import tompkins.studio.RideMoment;
import tompkins.studio.Studio;
import tompkins.studio.Studios;
import tompkins.surface.Clock;
import tompkins.surface.Surface;
import tompkins.ui.compare.ComparePanel;
import tompkins.ui.compare.Compared;
import tompkins.ui.model.Pace;
import tompkins.ui.model.StudioModel;
import tompkins.ui.photograph.PhotographView;
import tompkins.ui.picture.Comparison;
import tompkins.ui.picture.ScreenPicture;

@LightLook
@Timeout(120)
class RideBesideRestTest {

    private final StudioModel model = new StudioModel(opened(Studios.sphere(), 0), null);

    @AutoClose
    private final PhotographView view =
            WindowDriver.onEventThread(() -> new PhotographView(model, new SilentListener()));

    @BeforeEach
    void size() {
        WindowDriver.onEventThread(() -> {
            view.canvas().setSize(64, 48);
            view.render();
            view.compare(new Compared(ComparePanel.Other.AT_REST, null, Comparison.SPLIT, "at rest"));
        });
    }

    private static Studio opened(Studio studio, double time) {
        return studio.withVelocity(Velocity.REST)
                .withCamera(studio.camera().withShutter(new AperturePlaneShutter(time)));
    }

    private ScreenPicture shown() {
        return view.canvas().shown();
    }

    private void awaitPictures(String what) {
        WindowDriver.await(
                what,
                () -> shown().now() != null
                        && shown().other() != null
                        && shown().other().complete()
                        && shown().now().studio().equals(model.studio()));
    }

    /** As the clock of a ride does, which asks again and again. */
    private void awaitTicking(String what, BooleanSupplier condition) {
        WindowDriver.await(what, () -> {
            Studio now = model.studio();
            double time = now.camera().shutter().openingTime();
            double next = time + Math.ulp(time);
            model.flow(now.withCamera(now.camera().withShutter(new AperturePlaneShutter(next))), model, Pace.RIDE);
            return condition.getAsBoolean();
        });
    }

    private static void goOn(StudioModel model, Studio studio) {
        WindowDriver.onEventThread(() -> model.flow(studio, model, Pace.RIDE));
    }

    /** A picture that takes minutes must not stand beside a ride meanwhile. */
    @Test
    void aRideDoesNotWaitForThePictureBefore() {
        awaitPictures("the first pictures");
        WindowDriver.onEventThread(() -> {
            model.set(Studios.slow());
        });
        goOn(model, opened(Studios.sphere(), 3));
        awaitTicking(
                "the picture at rest beside the ride",
                () -> shown().other().studio().scene().equals(Studios.sphere().scene()));
    }

    @Test
    void clocksAreSeenToGo() {
        Surface clock = Clock.DEFAULT;
        Studio clocks = model.studio().withScene(List.of(new Sphere("clock", new Vector3d(0, 0, 10), 1, clock)));
        WindowDriver.onEventThread(() -> model.set(clocks));
        awaitPictures("the first pictures");
        goOn(model, opened(clocks, 3));
        awaitTicking(
                "a later picture at rest",
                () -> shown().other().studio().camera().shutter().openingTime() >= 3);
    }

    /** In the frame of the moving camera z would be (1 - cosh(a s))/a. */
    @Test
    void theCameraAtRestIsWhereTheRideIs() {
        RideMoment moment = RideMoment.start(model.studio()).after(new Vector3d(0, 0, 1), 0.5);
        WindowDriver.onEventThread(() -> view.setRideAtRest(moment::atRest));
        goOn(model, moment.studio());
        double place = Math.cosh(0.5) - 1;
        awaitTicking(
                "the picture at rest where the ride is",
                () -> shown().other() != null
                        && Math.abs(shown().other().studio().camera().position().z() - place) < 1e-12);
    }
}
