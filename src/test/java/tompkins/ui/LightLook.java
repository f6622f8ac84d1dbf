package tompkins.ui;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.extension.ExtensionContext;
import tompkins.ui.widget.Look;

/** Tests whose components have the usual look; it is there again after those that try others. */
@Target(ElementType.TYPE)
@Retention(RetentionPolicy.RUNTIME)
@ExtendWith(LightLook.Install.class)
public @interface LightLook {

    /** Installs it. */
    final class Install implements BeforeAllCallback, AfterAllCallback {

        @Override
        public void beforeAll(ExtensionContext context) {
            WindowDriver.onEventThread(() -> Look.LIGHT.install());
        }

        @Override
        public void afterAll(ExtensionContext context) {
            beforeAll(context);
        }
    }
}
